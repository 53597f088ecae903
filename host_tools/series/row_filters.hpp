#pragma once

#include "series/signal_series.hpp"

namespace fogcomp {

/// How far a first-order lag of `values` (one per row) is behind them: value - lag. Every recording
/// begins with the lag at its first value.
Eigen::VectorXd behind_lag(const Rows& rows, const Eigen::VectorXd& values, double tau_s);

}  // namespace fogcomp
