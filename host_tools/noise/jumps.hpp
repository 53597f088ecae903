#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::noise {

/// Divides stretches of noise where their level jumps: a single jump is an event, and would count
/// as much slow noise. A jump exceeds the usual differences of means of 8 to 64 rows, and is as
/// high within half as many rows. Parts have at least 32 rows.
std::vector<Eigen::VectorXd> split_at_jumps(const std::vector<Eigen::VectorXd>& stretches);

}  // namespace fogcomp::noise
