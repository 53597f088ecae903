#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// The rows with a constant, settled temperature, in which a model's residual is noise: |dT/dt| at
/// most 5 % of that of the ramps (or 0.02 degC/min), without gaps, at least 32 rows. A jump of
/// another input starts a new range, and so does a change of the input rate by more than 1 % of its
/// range in the recordings or 0.1 deg/s, whichever is larger: a rate table that sweeps is not
/// quiet.
std::vector<recording::RowRange> quiet_ranges(const series::Rows& rows);

/// The parts of a vector with one value per row.
std::vector<Eigen::VectorXd> parts_of(const Eigen::VectorXd& values,
                                      const std::vector<recording::RowRange>& ranges);

/// The parts of a residual in quiet_ranges().
std::vector<Eigen::VectorXd> quiet_stretches(const series::Rows& rows,
                                             const Eigen::VectorXd& residual);

/// Noise of a residual: from its quiet parts or, without any, white noise from neighbouring rows.
/// Outliers have to be bridged before.
NoiseModel noise_of(const series::Rows& rows, const Eigen::VectorXd& residual);

}  // namespace fogcomp::noise
