#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// The rows in which the temperature stands still and has settled, so that what a model leaves
/// there is noise: |dT/dt| at most 5 % of what the ramps have (or 0.02 degC/min), without gaps, at
/// least 32 rows. Where another input jumps, a new stretch begins.
std::vector<recording::RowRange> quiet_ranges(const series::Rows& rows);

/// The parts of a value per row.
std::vector<Eigen::VectorXd> parts_of(const Eigen::VectorXd& values,
                                      const std::vector<recording::RowRange>& ranges);

/// The parts of a residual in quiet_ranges().
std::vector<Eigen::VectorXd> quiet_stretches(const series::Rows& rows,
                                             const Eigen::VectorXd& residual);

/// The noise of a residual: from its quiet parts, or where there are none white, from neighbouring
/// rows. Outliers are to be bridged before.
NoiseModel noise_of(const series::Rows& rows, const Eigen::VectorXd& residual);

}  // namespace fogcomp::noise
