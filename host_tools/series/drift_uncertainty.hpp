#pragma once

#include <Eigen/Core>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::series {

/// Standard deviation of the drift that a board subtracts in each row, deg/h: of coefficients and
/// shapes, and what the delay of its derivative changes; without the noise of the rate. Requires
/// Model::uncertainty; `series`: in Phase::board.
Eigen::VectorXd drift_sigma_dph(const model::Model& model, const SignalSeries& series);

}  // namespace fogcomp::series
