#pragma once

#include <Eigen/Core>

#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Modes of a random walk of the bias over each recording: rows x modes (Karhunen-Loeve, the
/// strongest of each recording), deg/h. A walk of coefficient K, in deg/h/sqrt(h), is the sum of
/// all modes, each times K and an independent normal variable of variance 1, except for its start,
/// which is the recording's own bias, and for variations faster than the modes.
Eigen::MatrixXd random_walk_modes(const series::Rows& rows);

}  // namespace fogcomp::noise
