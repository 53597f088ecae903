#pragma once

#include <cmath>
#include <cstddef>

/// All thresholds of a diagnosis: unit, origin, and the test that protects them ("hidden effects"
/// is tests/bench/hidden_effects; "clean gyros" its faultless cases and
/// tests/integration/diagnose.sh). Constants that only define a search grid or its cost are next to
/// their use.
namespace fogcomp::diagnosis::rules {

// ---- Is there anything beside noise? ----------------------------------------------------------
/// Chance that noise alone has it, as its natural logarithm, below which fast structure is told:
/// three tests without a physical model. At 0.05 % a cycle was reported for 1 of 300 clean gyros.
inline const double kFastLogP = std::log(0.00001);

/// Minimum number of rows: needed to fit a few effects and their noise.
constexpr std::ptrdiff_t kMinRows = 60;

/// Degrees of freedom of the soaks above which they alone determine the slow noise; below, the
/// high-pass part of the other rows is used as well. Clean gyros with short soaks.
constexpr double kEnoughFreedom = 12;

/// Fraction of a row's noise variance (a fifth of the noise rms): one recording cannot tell a
/// smaller excess from noise that is slower than its soaks. The smallest size of the hidden
/// effects. Clean gyros.
constexpr double kSmallExcess = 0.2 * 0.2;

// ---- Which effect is it? ----------------------------------------------------------------------
/// Decrease of chi^2, beside smooth functions, above which a step is moved from its grid time to
/// its row: the largest of 6000 rows of white noise exceeds this once in 600,000 recordings (chi^2
/// of one degree of freedom).
constexpr double kMinPlacedChi2Drop = 40;

/// The same beside nothing but the model, where slow noise looks like steps: as for other shapes.
constexpr double kMinMovedChi2Drop = 100;

/// Probability above which one effect is named (nothing is missing, doubtful below the rest), and
/// above which it is one of the rivals. Calibrated with the hidden effects.
constexpr double kNamed = 0.9;
constexpr double kConfusable = 0.05;

// ---- What to add, and when to stop ------------------------------------------------------------
/// Fraction of an effect that the model must leave for the effect to be visible; with less it would
/// have to be thirty times larger than what it shows.
constexpr double kMinVisible = 0.03;

}  // namespace fogcomp::diagnosis::rules
