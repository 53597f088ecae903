#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/signal_series.hpp"

namespace fogcomp {

/// The stretches of a residual in which the temperature stands still and has settled, so that what
/// is left there is noise: |dT/dt| at most 5 % of what the ramps have (or 0.02 degC/min), without
/// gaps, at least 32 rows. Where another input jumps, a new stretch begins.
std::vector<Eigen::VectorXd> quiet_stretches(const Rows& rows, const Eigen::VectorXd& residual);

}  // namespace fogcomp
