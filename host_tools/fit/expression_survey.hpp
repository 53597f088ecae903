#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Gives every expression among `terms` the ranges of its signals over the recordings, widened by a
/// quarter of their span or size; temperature rate as far as the board knows it, time to sixteen
/// times the longest recording. Throws InputError where an expression is not finite over the
/// recordings, or the same all the time.
void set_expression_ranges(std::vector<model::EffectTerm>& terms,
                           const series::SignalSeries& series);

/// Chooses the scale of an expression's regressor: the power of two at which it stays below 2 over
/// the recordings, a quarter of what the board holds. The coefficient follows. Other terms stay.
void set_expression_scale(model::EffectTerm& term, const series::SignalSeries& series);

}  // namespace fogcomp::fit
