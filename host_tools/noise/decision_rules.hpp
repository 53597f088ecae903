#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

/// Every number by which noise, outliers and steps are told from each other: its unit, where it
/// comes from, and what looks at the decision (a test of tests/unit/noise unless a folder is named;
/// not all fail at twice the number). Numbers that only lay out a search or bound its cost stand
/// where they are used.
namespace fogcomp::noise::rules {

// ---- Allan deviation and its coefficients -----------------------------------------------------
/// Neighbouring pairs behind a point: one pair has no scatter. allan_test.
constexpr double kMinAllanPairs = 2;

/// Of sigma^2, relative: what no sum of power laws describes, such as filters. Intervals of 95 %
/// that hold 90 of 100 simulated truths: statistics/noise_coefficients_test.
constexpr double kAllanModelError = 0.01;

/// Score within which a set of terms is as good as the best: two standard errors of one
/// coefficient, squared. statistics/noise_coefficients_test.
constexpr double kPlausibleScore = 4;

// ---- Noise floor ------------------------------------------------------------------------------
/// Second differences from which a floor is known to 0.6 / sqrt(30) = 11 %; with fewer, of shorter
/// means. noise_floor_test.
constexpr std::size_t kMinFloorDifferences = 30;

/// Means for each part of a scale factor's error that is taken out of them: it takes a tenth of the
/// noise's variance with it, 5 % of the floor. noise_floor_test.
constexpr std::size_t kMeansPerColumn = 10;

/// Standard deviations beyond which a difference is a spike or a step: one of 2,000 of noise alone.
/// noise_floor_test.
constexpr double kFloorCut = 3.5;

// ---- Which rows are quiet ---------------------------------------------------------------------
/// A soak's temperature rate, degC/min: this, which is 1.2 degC/h, or this share of a fast ramp's
/// (which a quantile of all rows tells). Chosen: a chamber settles to a few hundredths of its
/// ramp. quiet_rows_test.
constexpr double kMaxQuietRate = 0.02;
constexpr double kQuietShareOfRamps = 0.05;
constexpr double kRampQuantile = 0.95;

/// Rows without a pause for a spectrum of 16 frequencies. quiet_rows_test.
constexpr std::size_t kMinQuietRows = 32;

/// Share of an input's range: a larger change from row to row is an axis that is turned, a field
/// that is switched on. Chosen. quiet_rows_test.
constexpr double kInputJump = 0.25;

// ---- Noise model ------------------------------------------------------------------------------
/// Standard deviations at which a row is clipped before its periodogram: noise alone is beyond them
/// in 1 of 16,000 rows. noise_model_test.
constexpr double kMaxSpectrumSigmas = 4;

/// Periods in a run: what is slower than these is the model's, not the noise's. Half or twice as
/// many move no unit test; tests/bench/hidden_effects, clean gyros.
constexpr double kMinNoisePeriods = 4;

/// Degrees of freedom of the slow noise, at least and at most. Chosen; beyond a thousand nothing
/// changes. tests/bench/hidden_effects, clean gyros.
constexpr double kMinFreedom = 3;
constexpr double kMaxDegreesOfFreedom = 1000;

/// Of the white variance: a component below is dropped. It is a tenth of the variance that white
/// noise leaves in the mean of a day's rows of 10 s. noise_model_test.
constexpr double kNegligibleComponent = 1e-5;

// ---- Noise that differs along a run -----------------------------------------------------------
/// Rows of a window: their noise is known to 19 % (noise_scale.cpp). noise_scale_test.
constexpr std::size_t kScaleWindow = 64;

/// Standard errors by which windows must scatter more than with equal noise. noise_scale_test.
constexpr double kBeyondChance = 3;

// ---- Outliers ---------------------------------------------------------------------------------
/// Standard deviations of white noise, at least (Chauvenet's criterion asks for more in a long
/// recording, up to the second): 1 of 16,000 rows of noise. outlier_rows_test.
constexpr double kMinOutlierSigmas = 4;
constexpr double kMaxOutlierSigmas = 10;
/// Chauvenet: so many rows of noise alone are expected beyond.
constexpr double kRowsBeyond = 0.5;

/// Scatters of the neighbours: an effect that decays within 2 rows reaches 2.9. outlier_rows_test.
constexpr double kOutlierScatters = 3;

/// Neighbours on either side: their median is of one of them, and an event of three rows is found.
/// outlier_rows_test.
constexpr std::size_t kNeighbours = 3;
/// Rows within which neighbours with the same inputs are looked for. Chosen. outlier_rows_test.
constexpr std::size_t kNeighbourReach = 20;
/// Share of an input's range within which it is the same. As kInputJump. outlier_rows_test.
constexpr double kSameInput = 0.25;

/// Rows on either side whose noise is known together, to 21 %, and second differences that are too
/// few to tell it. outlier_rows_test.
constexpr std::size_t kRowsAround = 25;
constexpr std::size_t kFewBends = 12;

// ---- Jumps of quiet stretches, which are events and no slow noise -----------------------------
/// Rows on either side that are compared. jumps_test.
constexpr std::array<Eigen::Index, 4> kJumpWidths{8, 16, 32, 64};
/// Standard deviations of such differences, slow noise included: a chance of 4e-8 for each place.
/// jumps_test.
constexpr double kMinJump = 5.5;
/// Share of the jump that half the width shows: a ramp shows half, a jump all. jumps_test.
constexpr double kMinJumpShare = 0.7;
/// Standard deviations of a step from row to row by which a single row is a spike. jumps_test.
constexpr double kSpike = 3;
/// Rows of a part, as kMinQuietRows. jumps_test.
constexpr Eigen::Index kMinPartRows = 32;
/// Places that share no row, for a standard deviation to 18 %. jumps_test.
constexpr std::size_t kMinPlaces = 16;

// ---- Steps of the bias ------------------------------------------------------------------------
/// Rows on each side of a step, for its size to a third of a row's noise.
/// tests/unit/fit/step_search_test.
constexpr Eigen::Index kMinRowsBeside = 10;
/// Chi^2 below the best within which a step may lie: three standard deviations.
/// tests/unit/fit/step_search_test.
constexpr double kStepWithin = 9;
/// Share of a step that the model's columns leave, below which it is theirs: rounding.
constexpr double kUndeterminedStep = 1e-6;

// ---- Values that go together ------------------------------------------------------------------
/// Correlation lengths over which correlations are summed: of e^-5 nothing is left, and the
/// scatter of further ones would enter. autocorrelation_test.
constexpr double kCorrelationWindow = 5;

}  // namespace fogcomp::noise::rules
