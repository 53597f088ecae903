#pragma once

#include <string>
#include <vector>

#include "core/signal/inputs.hpp"
#include "diagnosis/form_meaning.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::diagnosis {

/// Lags that are tried: from barely visible in a row to still visible in a programme of hours.
inline constexpr double kShortestLag_s = 20;
inline constexpr double kLongestLag_s = 6000;

/// A formula outside the catalogue, as an expression without coefficients.
struct Formula {
  model::EffectTerm term;
  FormMeaning meaning;
};

/// Formulas outside the catalogue. For every signal of
/// `inputs` that varies on these rows: an extension input itself, squares, cubes, magnitudes,
/// products of up to three factors of two signals (for a temperature also its distance from a
/// fitted reference, and a ripple over it), a lag before or after it, a kink and a sine of it; of
/// the temperature its highest value so far. Parameter bounds follow from the range of the signal.
/// Without those that an effect of the catalogue contains on these rows.
std::vector<Formula> formulas_over(const series::SignalSeries& series, fog::InputMask inputs);

/// An expression for the reader: parameters by name, without bounds.
std::string form_text(const model::Expression& expression);

}  // namespace fogcomp::diagnosis
