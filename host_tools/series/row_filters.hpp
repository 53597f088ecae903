#pragma once

#include "series/rows.hpp"

namespace fogcomp::series {

/// First-order lag of `values` (one per row), stepped by the time between rows. Every recording
/// starts in the steady state at its first value.
Eigen::VectorXd first_order_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s);

/// The same once forward and once backward: smoother, without delay.
Eigen::VectorXd smoothed(const Rows& rows, const Eigen::VectorXd& values, double tau_s);

}  // namespace fogcomp::series
