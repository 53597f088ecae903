#pragma once

#include <cstddef>

/// All thresholds of a fit: unit, origin, and the test that examines the decision (in
/// tests/unit/fit unless a folder is named). Constants that only define a search grid or its cost,
/// and published constants of trainers (TRAINING.md), are next to their use.
namespace fogcomp::fit::rules {

// ---- Warnings of a fit about its effects ------------------------------------------------------
/// Correlation of two effects' coefficients that is reported: each is three times less certain than
/// alone. identify_test.
constexpr double kConfused = 0.95;
/// Standard deviations above which an effect is certainly visible. identify_test.
constexpr double kVisible = 5;
/// degC/min: a step of the bias in a faster ramp may be a missing effect. Chosen: soaks are below,
/// ramps above (recording/decision_rules.hpp). bias_steps_test.
constexpr double kRampDegcPerMin = 0.1;
/// degC beyond the coldest and warmest row, so that sensor noise at the end of the range does not
/// count as outside. tests/unit/compare/trained_range_test.
constexpr double kRangeMarginDegc = 1;
/// Probability of a reported bias difference between runs of one gyro that differ only by noise: 1
/// %, as in the other tests of the project. turn_on_bias_test.
constexpr double kFalseTurnOn = 0.01;

// ---- What the recordings do not determine -----------------------------------------------------
/// Limits that select the wording of a refusal: start times above so many lengths of the longest
/// recording do not look like time since power-on; temperature ranges, degC, that count as
/// constant. undetermined_test.
constexpr double kLateStart = 10;
constexpr double kStillDegc = 1;

/// degC: recorded temperatures that can hold an effect's place span at least this, twice the widest
/// glass transition. reference_values_test, tests/integration/bad_input.sh.
constexpr double kMinSpanOfPlaceDegc = 16;

// ---- Steps of the bias ------------------------------------------------------------------------
/// Smallest accepted chi^2 of a step. In flicker noise alone the best step has 10 to 30; 0 of 100
/// clean runs exceeded this, and 20 of 20 steps of 5 sigma of a row did. step_search_test,
/// tests/statistics/bias_steps_test.
constexpr double kMinStepChiSquare = 60;
/// The same before the noise is estimated from a fit with the step. step_search_test.
constexpr double kWorthALook = 8;
/// Smallest chi^2 by which the other recordings tell that their bias is not the one that a step is
/// expected to leave, as one coefficient of noise has. bias_steps_test.
constexpr double kMinLevelGain = 1;
/// Largest chi^2 by which a change over minutes may explain more than a step: three standard
/// deviations. More is slow noise, or an effect that the model lacks: a bias jumps within a row.
/// step_search_test.
constexpr double kMaxGradualGain = 9;
/// Seconds: slower changes are drift, not steps. bias_steps_test.
constexpr double kSlowSeconds = 3600;

// ---- Does it help out of sample? --------------------------------------------------------------
/// Ratio of an error that rises at temperatures not fitted to what the uncertainty of the fit
/// allows, above which the form is wrong: two standard deviations. Of 62 formulas that were a
/// simulated gyro's own three raised it, to 1.5 at most; of seven descriptions of a pyroelectric
/// error four to 2.3 and more. addition_judge_test.
constexpr double kBeyondExpected = 2;
/// Smallest chi^2 drop that counts as help (OutOfSample::chi2_drop): about an effect of four
/// standard deviations. Six effects that a simulated gyro does not have, tried on 100 of its
/// recordings each (white and slow noise, cross-validated), reached it 6 times in 600.
/// add_effect_test, tests/statistics/add_effect_test.
constexpr double kMinChi2Drop = 10;
/// Size up to which a chi^2 drop says nothing: on a run that shows nothing of a set it is about -1
/// +- 2 (OutOfSample::chi2_drop); two standard deviations.
/// tests/unit/diagnosis/addition_judge_test.
constexpr double kMaxUselessDrop = 5;
/// Largest deviation, in standard deviations, with which a row is counted. add_effect_test.
constexpr double kMaxCounted = 4;
/// Fraction of the noise variance above which a component's memory counts. add_effect_test.
constexpr double kMinRemembered = 0.01;
/// Length of a stretch in units of that memory, and minimum and maximum number of stretches: in
/// shorter ones the neighbours predict the noise. add_effect_test.
constexpr double kMemories = 3;
constexpr double kMinStretches = 10;
constexpr double kMaxStretches = 50;
/// An effect that acts in a part of a run only, as a warm-up at its start, is judged by stretches
/// that are so much shorter, of at least so many rows, if those left in then determine it, and if
/// quiet parts tell the noise: else only long stretches tell an effect from slow noise. Warm-ups of
/// 90 clean gyros with flicker noise and random walks: none accepted. add_effect_test.
constexpr double kShorter = 4;
constexpr double kMinRowsOfShort = 6;
/// Number of runs from which on each is left out in turn. add_effect_test.
constexpr std::size_t kEnoughRuns = 3;
/// Ratio of uncertainties to those with all rows: above the first a run without an effect cannot
/// judge one with it; above the second a half cannot identify the model. Chosen. add_effect_test.
constexpr double kMuchWorse = 4;
constexpr double kFarWorse = 20;
/// Standard deviations that the sum of squares on holdouts exceeds once in 100 times by chance.
/// add_effect_test.
constexpr double kOneIn100 = 2.33;

// ---- A random walk instead of an effect -------------------------------------------------------
/// Probability of a random walk above which an effect is not accepted: random walks of 0.003 to
/// 0.02 deg/h/sqrt(h) were taken for ageing or a step in 8 to 17 of 20 clean runs. walk_rival_test,
/// add_effect_test, tests/bench/hidden_effects.
constexpr double kMaxChanceOfWalk = 0.01;
/// ln of the odds below which the quiet parts exclude a walk: three standard deviations.
/// tests/bench/hidden_effects.
constexpr double kWalkRuledOut = -4.5;
/// Smallest fraction of a column that a model must leave; below it the column belongs to the model,
/// as for the candidates of a diagnosis (diagnosis/candidates.hpp). tests/bench/hidden_effects.
constexpr double kMinSeen = 0.03;

// ---- How exact is a formula? ------------------------------------------------------------------
/// Relative error allowed to a formula: no catalogue describes a gyro exactly.
/// explained_space_test, tests/bench/hidden_effects.
constexpr double kModelFormTolerance = 0.005;

// ---- Uncertainties: what can be slow in a residual --------------------------------------------
/// Number of modes up to which a missing effect has equal power, for programmes with few ramps and
/// with many: programmes have about ten to thirty. tests/statistics/uncertainty_test.
constexpr double kCornerSlow = 8;
constexpr double kCornerFast = 32;

// ---- Expressions ------------------------------------------------------------------------------
/// Widening of a signal's observed range for the board, relative to its span or size; for the time
/// since power-on a factor. noise_weighted_fit_test, tests/property/expression_test.
constexpr double kSignalWidening = 0.25;
constexpr double kTimeWidening = 16;

}  // namespace fogcomp::fit::rules
