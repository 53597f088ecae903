#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::noise {

/// Parts stretches of noise where their level jumps: an event is no noise, and one alone would pass
/// for a great deal of slow noise. A jump stands out of what means of the same 8 to 64 rows differ
/// by elsewhere, and is as high within half as many rows. Parts are of 32 rows or more.
std::vector<Eigen::VectorXd> parted_at_jumps(const std::vector<Eigen::VectorXd>& stretches);

}  // namespace fogcomp::noise
