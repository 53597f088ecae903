#pragma once

#include <cstddef>

/// All thresholds of a fit: unit, origin, and the test that examines the decision (in
/// tests/unit/fit unless a folder is named). Constants that only define a search grid or its cost,
/// and published constants of trainers (network/README.md), are next to their use.
namespace fogcomp::fit::rules {

// ---- Warnings of a fit about its effects ------------------------------------------------------
/// Correlation of two effects' coefficients that is reported: each is three times less certain than
/// alone. identify_test.
constexpr double kConfused = 0.95;
/// degC beyond the coldest and warmest row, so that sensor noise at the end of the range does not
/// count as outside. tests/unit/compare/trained_range_test.
constexpr double kRangeMarginDegc = 1;

// ---- What the recordings do not determine -----------------------------------------------------
/// Limits that select the wording of a refusal: start times above so many lengths of the longest
/// recording do not look like time since power-on; temperature ranges, degC, that count as
/// constant. undetermined_test.
constexpr double kLateStart = 10;
constexpr double kStillDegc = 1;

/// degC: recorded temperatures that can hold an effect's place span at least this, twice the widest
/// glass transition. reference_values_test, tests/integration/bad_input.sh.
constexpr double kMinSpanOfPlaceDegc = 16;

// ---- Does it help out of sample? --------------------------------------------------------------
/// Number of runs from which on each is left out in turn. add_effect_test.
constexpr std::size_t kEnoughRuns = 3;

// ---- How exact is a formula? ------------------------------------------------------------------
/// Relative error allowed to a formula: no catalogue describes a gyro exactly.
/// turn_on_bias_test, tests/bench/hidden_effects.
constexpr double kModelFormTolerance = 0.005;

// ---- Expressions ------------------------------------------------------------------------------
/// Widening of a signal's observed range for the board, relative to its span or size; for the time
/// since power-on a factor. noise_weighted_fit_test, tests/property/expression_test.
constexpr double kSignalWidening = 0.25;
constexpr double kTimeWidening = 16;

}  // namespace fogcomp::fit::rules
