#pragma once

#include <Eigen/Core>

#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Modes of a random walk of the bias over each recording: rows x modes (Karhunen-Loeve, the
/// strongest of each recording), deg/h. A walk of coefficient K, in deg/h/sqrt(h), is the sum of
/// all modes, each times K and an independent normal variable of variance 1, except for its start,
/// which is the recording's own bias, and for variations faster than the modes. `relative`: largest
/// coefficient of interest over the white noise of a row, in 1/sqrt(h): as many modes as such a
/// walk makes visible, but at least 8 a recording, and a hundred or so in all.
Eigen::MatrixXf random_walk_modes(const series::Rows& rows, double relative);

}  // namespace fogcomp::noise
