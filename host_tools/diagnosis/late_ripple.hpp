#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// A ripple over the temperature of a part that is warmed late: an interfering path away from the
/// sensor. Over the sensor's own temperature (polarization_ripple) heating and cooling are out of
/// phase, and what is left looks like cycles in time. `left`: whitened residual, one value per row,
/// of variance 1 where it is noise. Returns `NAME = EXPRESSION` for `add` to a model of these
/// terms, bounds around the best lag and period of a grid, first narrow, then wide; nothing if that
/// explains less than kMost of what is above the noise.
std::vector<std::string> find_late_ripples(const series::SignalSeries& series,
                                           const std::vector<model::EffectTerm>& terms,
                                           const Eigen::VectorXd& left);

}  // namespace fogcomp::diagnosis
