#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// Every number by which a diagnosis decides: its unit, where it comes from, and what holds it
/// ("hidden effects" is tests/bench/hidden_effects, "clean gyros" its faultless cases and
/// tests/integration/diagnose.sh). Numbers that only lay out a search or bound its cost stand where
/// they are used.
namespace fogcomp::diagnosis::rules {

// ---- Is there anything beside noise? ----------------------------------------------------------
// Logarithms of the chance that noise alone is called a fault. Small where a single shape or line
// decides, because no gyro is quite what its noise and its model say: at a chance of 1 % every
// twentieth faultless simulated gyro was beyond it, and at 0.01 % 2 of 300 whose temperatures were
// logged 300 s late had an effect named. Smooth structure is a sum over many directions: of 548
// tests on faultless gyros, half of them with a recording at rest, the smallest chance was 2 %.
// Fast structure is three tests, and no physics stands behind what they find: 1 of 300 clean gyros
// was called a cycle at a chance of 0.05 %. Chances of 1e-5 make one false alarm in 25,000 gyros.
// Clean gyros.
inline const double kLibraryLogP = std::log(0.00001);
inline const double kStructureLogP = std::log(0.01);
inline const double kFastLogP = std::log(0.00001);

/// Rows for any opinion: what a fit of a few effects and their noise needs.
constexpr std::ptrdiff_t kMinRows = 60;

/// Degrees of freedom with which soaks alone tell the slow noise; below, the faster part of
/// everything else helps. Clean gyros with short soaks.
constexpr double kEnoughFreedom = 12;

/// Share of a row's noise variance, a fifth of the noise: one recording cannot tell what is smaller
/// from noise that is slower than its soaks. The smallest size of the hidden effects. Clean gyros.
constexpr double kSmallExcess = 0.2 * 0.2;

/// Of the white noise, what a model leaves more than that: only the soaks say that it is noise.
constexpr double kMuchAboveWhite = 0.1;

/// Share of quiet rows from which on a recording is one at rest.
constexpr double kAtRest = 0.9;

// ---- Which effect is it? ----------------------------------------------------------------------
/// Prior odds of one more missing effect against none more, and of an effect against one with a
/// parameter more. Stated probability against frequency in the hidden effects.
constexpr double kAnother = 0.15;
constexpr double kSimpler = 4;

/// Fall of chi^2 that each part of a set must bring: 99.8 % of one direction of noise. Events need
/// more evidence than physics, as flicker noise looks like steps.
constexpr double kMinPartChi2Drop = 10;
constexpr double kMinStepChi2Drop = 60;

/// Fall of chi^2 by which a shape is not the best any more: three standard deviations.
constexpr double kPossible = 9;

/// Probability from which one effect is named, and from which it is among the rivals. Stated
/// probability against frequency in the hidden effects.
constexpr double kNamed = 0.92;
constexpr double kConfusable = 0.05;

/// Odds of evidence from which an effect is believed where no test finds anything.
constexpr double kBelievedOdds = 20;

// ---- Does it explain enough? ------------------------------------------------------------------
/// Of the excess, by one, two, three effects: what leaves more than that does not explain it.
/// Several effects together imitate a good deal of what is none of them. Hidden effects outside the
/// catalogue.
constexpr std::array<double, 3> kMaxUnexplained{0.1, 0.06, 0.05};

/// The same by three that temperature and time alone drive, of which nearly every function of these
/// can be made: of 156 gyros with an effect outside the catalogue, visible as 0.7 of the noise, six
/// were explained so within 0.05; of 166 with three catalogued effects three leave more than this.
/// Not where an effect leads whose shape is fixed: that is not bent into an imitation.
constexpr double kMaxUnexplainedByThreeFreeShape = 0.025;

/// The same by an event, whose form is exact where a physical effect's is not: a maximum that is
/// kept, or a load that is slow to settle, is like a step in all but a few hundredths.
constexpr double kMaxUnexplainedByEvent = 0.03;

/// Logarithm of the chance of a leftover that may be noise.
constexpr double kLeftoverLogP = -7;

/// Evidence for an input, beside the temperature and its rate, relative to that for the variable on
/// which what is left depends most, from which formulas are looked for in it, too: what depends on
/// the input alone has 1, what depends on it and as much on another variable half.
constexpr double kMinShareOfInput = 0.5;

// ---- What to add, and when to stop ------------------------------------------------------------
/// Of rivals another is added first that leaves so much less and is nearly as likely as the best.
constexpr double kClearlyLess = 0.97;
constexpr double kNearlyAsLikely = 1.0 / 3;

/// Share of the excess that the main part of something not understood explains.
constexpr double kMainPart = 0.5;

/// Row lengths that a diagnosis may take, seconds: the first that gives no more than kMaxRows.
/// Means over 10 s hold what the catalogue makes of temperature, and the chances of the tests are
/// those of such rows (tests/bench/hidden_effects).
constexpr std::array<double, 4> kRowLengths_s{10, 20, 30, 60};
constexpr double kMaxRows = 12000;

/// Share of an effect that the model must leave for it to be seen: of less it would have to be
/// thirty times what it shows.
constexpr double kMinVisible = 0.03;

/// An addition that lowers the error by less than this share hardly helps.
constexpr double kHardlyHelps = 0.1;

/// Of all that was taken out of the model's error since it was fitted, in mean square: an addition
/// that brings less, and hardly helps, may be how inexactly those before it describe what they took
/// out.
constexpr double kWorthAdding = 0.025;

}  // namespace fogcomp::diagnosis::rules
