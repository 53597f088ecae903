#pragma once

#include <vector>

#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Sets the signal ranges of every expression among `terms`: the ranges in the recordings, widened
/// by a quarter of their span or size; the temperature rate limited to the board's range; time up
/// to sixteen times the longest recording. Throws InputError for an expression that is not finite
/// over the recordings, or 0 without a shape that could change it.
void set_expression_ranges(std::vector<model::EffectTerm>& terms,
                           const series::SignalSeries& series);

/// Chooses the scale of an expression's regressor: the power of two with which it stays below 2, a
/// quarter of the board's range, over the recordings. Scales the coefficient accordingly, and
/// returns by which power of two. Other terms are unchanged.
int set_expression_scale(model::EffectTerm& term, const series::SignalSeries& series);

}  // namespace fogcomp::fit
