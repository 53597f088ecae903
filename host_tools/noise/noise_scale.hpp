#pragma once

#include <Eigen/Core>

#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Standard deviation of each row's noise relative to the typical row's (1): a chamber's compressor
/// or a hot detector makes more of it in parts of a run. From how far each row lies from the middle
/// between its neighbours, so that what drifts beneath does not enter; in windows of 128 rows. As
/// far as these differ by no more than chance, all are
/// 1. `residual`: per row, deg/h. `counted`: 1 per row, 0 for rows that are left out.
Eigen::VectorXd noise_scale(const series::Rows& rows, const Eigen::VectorXd& residual,
                            const Eigen::VectorXd& counted);

}  // namespace fogcomp::noise
