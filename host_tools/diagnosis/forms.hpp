#pragma once

#include <string>
#include <vector>

#include "core/signal/inputs.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Formulas that the catalogue lacks, as expressions without coefficients: of every signal of
/// `inputs` that varies on these rows, squares, cubes, magnitudes, products of up to three factors
/// of two signals (of a temperature as its distance from one that is searched for, too), a lag
/// before or after it, a kink and a sine of it. Bounds of their parameters come from the range
/// of the signal. What a formula has in common with the model or the catalogue is left to those by
/// whoever lets them compete (find_candidates()).
std::vector<model::EffectTerm> formulas_over(const series::SignalSeries& series,
                                             fog::InputMask inputs);

/// An expression as a reader wants it: parameters by their names alone, without bounds.
std::string form_text(const model::Expression& expression);

}  // namespace fogcomp::diagnosis
