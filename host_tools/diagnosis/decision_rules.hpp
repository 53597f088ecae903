#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// All thresholds of a diagnosis: unit, origin, and the test that protects them ("hidden effects"
/// is tests/bench/hidden_effects; "clean gyros" its faultless cases and
/// tests/integration/diagnose.sh). Constants that only define a search grid or its cost are next to
/// their use.
namespace fogcomp::diagnosis::rules {

// ---- Is there anything beside noise? ----------------------------------------------------------
// Natural logarithms of false-alarm probabilities. Small where a single shape or line decides,
// because no gyro fits its noise model and drift model exactly: at 1 % every twentieth faultless
// simulated gyro exceeded it, and at 0.01 % an effect was named for 2 of 300 gyros whose
// temperatures were logged 300 s late. Smooth structure is a sum over many directions: in 548 tests
// on faultless gyros, half of them with a recording at rest, the smallest probability was 2 %. Fast
// structure is three tests without a physical model: at 0.05 % a cycle was reported for 1 of 300
// clean gyros. 1e-5 makes one false alarm in 25,000 gyros. Clean gyros.
inline const double kLibraryLogP = std::log(0.00001);
inline const double kStructureLogP = std::log(0.01);
inline const double kFastLogP = std::log(0.00001);

/// Chance that noise alone looks like this, below which something may be missing if an effect
/// lowers the error by kHardlyHelps: it is not named, and judged out of sample like a description.
/// Clean gyros, whose error no effect lowers so much.
constexpr double kFaintChance = 0.01;

/// Minimum number of rows: needed to fit a few effects and their noise.
constexpr std::ptrdiff_t kMinRows = 60;

/// Degrees of freedom of the soaks above which they alone determine the slow noise; below, the
/// high-pass part of the other rows is used as well. Clean gyros with short soaks.
constexpr double kEnoughFreedom = 12;

/// Fraction of a row's noise variance (a fifth of the noise rms): one recording cannot tell a
/// smaller excess from noise that is slower than its soaks. The smallest size of the hidden
/// effects. Clean gyros.
constexpr double kSmallExcess = 0.2 * 0.2;

/// Excess in units of the white noise: a larger one can be attributed to noise only by the soaks.
constexpr double kMuchAboveWhite = 0.1;

/// Fraction of quiet rows from which a recording counts as at rest.
constexpr double kAtRest = 0.9;

// ---- Which effect is it? ----------------------------------------------------------------------
/// Prior odds: of one more missing effect against none; and of an effect against one with one more
/// parameter. Calibrated with the hidden effects (stated probability against frequency).
constexpr double kAnother = 0.15;
constexpr double kSimpler = 4;

/// Decrease of chi^2 required of each part of a set: 99.8 % for one direction of noise. Events need
/// more, because flicker noise resembles steps.
constexpr double kMinPartChi2Drop = 10;
constexpr double kMinStepChi2Drop = 60;

/// Decrease of chi^2, beside smooth functions, above which a step is moved from its grid time to
/// its row. The test against noise knows the grid times only: the largest of 6000 rows of white
/// noise exceeds this once in 600,000 recordings (chi^2 of one degree of freedom).
constexpr double kMinPlacedChi2Drop = 40;

/// The same beside nothing but the model, where slow noise looks like steps: as for other shapes, a
/// chi^2 of 100 needs no test against noise.
constexpr double kMinMovedChi2Drop = 100;

/// A shape within this chi^2 of the best one is still possible: three standard deviations.
constexpr double kPossible = 9;

/// Probability of a random walk above which nothing is named; and above which no effect of time is,
/// which looks most like a walk. A clean gyro may have one of 0.003 to 0.02 deg/h/sqrt(h): with
/// 0.01 one in 100 of those was given an effect, with 0.001 one in 200, which was ageing, with
/// 0.0001 for effects of time none of 300. walk_finding_test, tests/bench/hidden_effects.
constexpr double kMaxChanceOfNamedWalk = 0.001;
constexpr double kMaxChanceOfWalkForTime = 0.0001;

/// Probability above which one effect is named, and above which it is one of the rivals. Calibrated
/// with the hidden effects.
constexpr double kNamed = 0.92;
constexpr double kConfusable = 0.05;

/// Odds above which an effect is accepted although no test finds anything.
constexpr double kBelievedOdds = 20;

// ---- Does it explain enough? ------------------------------------------------------------------
/// Largest unexplained fraction of the excess for one, two, three effects. Smaller for more
/// effects, because several together imitate much that is outside the catalogue. Hidden effects
/// outside the catalogue.
constexpr std::array<double, 3> kMaxUnexplained{0.1, 0.06, 0.05};

/// The same for three effects of temperature and time alone, which can imitate nearly any function
/// of these: of 156 gyros with an effect outside the catalogue, of 0.7 of the noise, six were
/// explained within 0.05; of 166 with three catalogued effects three leave more than this. Does not
/// apply if the leading effect has a fixed shape, which cannot be bent.
constexpr double kMaxUnexplainedByThreeFreeShape = 0.025;

/// The same for an event, whose form is exact: a maximum that is kept, or a load that settles
/// slowly, differs from a step by a few hundredths only.
constexpr double kMaxUnexplainedByEvent = 0.03;

/// Logarithm of the probability above which a remainder may be noise.
constexpr double kLeftoverLogP = -7;

/// Formulas use an input beside the temperature and its rate if its evidence is at least this
/// fraction of the strongest variable's. A residual that depends on the input alone gives 1, one
/// that depends equally on another variable 0.5.
constexpr double kMinShareOfInput = 0.5;

// ---- What to add, and when to stop ------------------------------------------------------------
/// Among rivals, one that is nearly as probable as the best is added first if its rms is below this
/// fraction of the best one's.
constexpr double kClearlyLess = 0.97;
constexpr double kNearlyAsLikely = 1.0 / 3;

/// A description that leaves at most this fraction of what a named effect leaves out of sample
/// refutes a name that does not help there. A third is what a description is to bring at least.
constexpr double kRefutes = 2.0 / 3;

/// Fraction of the excess above which a part counts as the main part of an unknown residual.
constexpr double kMainPart = 0.5;

/// Fraction of an effect that the model must leave for the effect to be visible; with less it would
/// have to be thirty times larger than what it shows.
constexpr double kMinVisible = 0.03;

/// An addition that lowers the error by less than this fraction hardly helps.
constexpr double kHardlyHelps = 0.1;

/// Fraction of the mean square removed from the model's error since its fit: an addition that
/// removes less, and hardly helps, may only correct inexact terms added before.
constexpr double kWorthAdding = 0.025;

}  // namespace fogcomp::diagnosis::rules
