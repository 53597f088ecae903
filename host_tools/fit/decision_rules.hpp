#pragma once

#include <cstddef>

/// Every number by which a fit decides: its unit, where it comes from, and what looks at the
/// decision (a test of tests/unit/fit unless a folder is named). Numbers that only lay out a
/// search, bound its cost or are a trainer's published constants (TRAINING.md) stand where they are
/// used.
namespace fogcomp::fit::rules {

// ---- What a fit says of its effects -----------------------------------------------------------
/// Correlation of two effects' coefficients worth a sentence: what either says of its own is known
/// three times worse than if it were alone. identify_test.
constexpr double kConfused = 0.95;
/// Standard deviations from which an effect would show for sure. identify_test.
constexpr double kVisible = 5;
/// degC/min: a step of the bias in a faster ramp may be an effect that is missing. Chosen: soaks
/// are below, ramps above (recording/decision_rules.hpp). bias_steps_test.
constexpr double kRampDegcPerMin = 0.1;
/// degC beyond the coldest and warmest row, so that sensor noise at the end of a range is not yet
/// outside it. tests/unit/compare/trained_range_test.
constexpr double kRangeMarginDegc = 1;
/// By which the derivative's time constant is shorter where the gyro's own lags are told. Smoothing
/// on both sides delays nothing but rounds corners, where a short lag shows: at the board's own
/// time constant 300 s would become 277 s, at a quarter of it 300 s. physical_lags_test.
constexpr double kSharperDerivative = 4;

/// Chance at which runs of one gyro that differ by noise alone are said to differ in their bias: of
/// every kind of finding the tests at 1 % are the project's. turn_on_bias_test.
constexpr double kFalseTurnOn = 0.01;

// ---- What the recordings do not determine -----------------------------------------------------
/// Lengths of the longest recording after which time_s does not seem to be since power-on, and degC
/// within which a temperature stands still: they choose the words of a refusal. undetermined_test.
constexpr double kLateStart = 10;
constexpr double kStillDegc = 1;

// ---- Steps of the bias ------------------------------------------------------------------------
/// Chi^2 of a step that is believed: of flicker noise alone the best has 10 to 30; 0 of 100 clean
/// runs had one above this, and 20 of 20 steps of 5 sigma of a row had. step_search_test,
/// tests/statistics/bias_steps_test.
constexpr double kMinStepChiSquare = 60;
/// The same before the noise is taken from a fit that knows the step. step_search_test.
constexpr double kWorthALook = 8;
/// Seconds: drift over hours is no jump. bias_steps_test.
constexpr double kSlowSeconds = 3600;

// ---- Does it help out of sample? --------------------------------------------------------------
/// Gain that counts as help (OutOfSample::gain): about an effect that stands out by four standard
/// deviations. Six effects that a simulated gyro does not have, each tried on 100 of its recordings
/// (white and slow noise, cross-validated), reached it 6 times in 600. add_effect_test,
/// tests/statistics/add_effect_test.
constexpr double kMinChi2Drop = 10;
/// Standard deviations that a row is counted with at most. add_effect_test.
constexpr double kMaxCounted = 4;
/// Share of the noise variance from which a component is remembered. add_effect_test.
constexpr double kMinRemembered = 0.01;
/// Lengths of that memory that a stretch is long, and stretches at least and at most: shorter ones
/// know the noise of their neighbours. add_effect_test.
constexpr double kMemories = 3;
constexpr double kMinStretches = 10;
constexpr double kMaxStretches = 50;
/// Runs from which each is left out in turn. add_effect_test.
constexpr std::size_t kEnoughRuns = 3;
/// Times as uncertain as with all rows: a run without such an effect cannot speak for one that has
/// it; a half that is worse than the second cannot identify the model. Chosen. add_effect_test.
constexpr double kMuchWorse = 4;
constexpr double kFarWorse = 20;
/// Standard deviations by which squares on holdouts rise once in 100 times by chance.
/// add_effect_test.
constexpr double kOneIn100 = 2.33;

// ---- A random walk instead of an effect -------------------------------------------------------
/// Chance of a random walk from which on an effect is not believed: rate random walks of 0.003 to
/// 0.02 deg/h/sqrt(h) were called ageing or a step in 8 to 17 of 20 clean runs. add_effect_test,
/// tests/bench/hidden_effects.
constexpr double kMaxChanceOfWalk = 0.01;
/// ln of the odds at which the quiet parts rule a walk out: three standard deviations.
/// tests/bench/hidden_effects.
constexpr double kWalkRuledOut = -4.5;
/// Share of a column that a model leaves, below which it is the model's own, as among the
/// candidates of a diagnosis (diagnosis/candidates.hpp). tests/bench/hidden_effects.
constexpr double kMinSeen = 0.03;

// ---- How exact is a formula? ------------------------------------------------------------------
/// Share of what is explained that a formula may be off by: no catalogue is exactly what a gyro
/// does. explained_space_test, tests/bench/hidden_effects.
constexpr double kModelFormTolerance = 0.005;

// ---- Uncertainties: what can be slow in a residual --------------------------------------------
/// Modes of a programme up to which an effect that the model lacks has as much power in each, one
/// of few ramps and one of many: programmes have about ten to thirty.
/// tests/statistics/uncertainty_test.
constexpr double kCornerSlow = 8;
constexpr double kCornerFast = 32;

// ---- Expressions ------------------------------------------------------------------------------
/// Beyond what was seen of a signal, share of its range or size, up to which a board may take it;
/// of the time since power-on so many times. noise_weighted_fit_test,
/// tests/property/expression_test.
constexpr double kSignalWidening = 0.25;
constexpr double kTimeWidening = 16;

}  // namespace fogcomp::fit::rules
