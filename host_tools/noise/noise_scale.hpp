#pragma once

#include <Eigen/Core>

#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Standard deviation of each row's noise relative to the typical row's (1): a chamber's compressor
/// or a hot detector increases it in parts of a run. Estimated from the distance of each row to the
/// mean of its neighbours, so that drift does not matter, in windows of 128 rows. All 1 if the
/// windows differ by no more than chance. `residual`: per row, deg/h. `counted`: 1 per row, 0 for
/// excluded rows.
Eigen::VectorXd noise_scale(const series::Rows& rows, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& counted);

}  // namespace fogcomp::noise
