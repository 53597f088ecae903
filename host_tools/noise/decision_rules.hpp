#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

/// All thresholds for noise, outliers and steps: unit, origin, and the test that examines the
/// decision (in tests/unit/noise unless a folder is named; not all tests fail at twice the value).
/// Constants that only define a search grid or its cost are next to their use.
namespace fogcomp::noise::rules {

// ---- Allan deviation and its coefficients -----------------------------------------------------
/// Smallest number of neighbouring pairs per point: one pair has no scatter. allan_test.
constexpr double kMinAllanPairs = 2;

/// Relative error of sigma^2 that no sum of power laws describes, such as filters. The 95 %
/// intervals contain 90 of 100 simulated true values: statistics/noise_coefficients_test.
constexpr double kAllanModelError = 0.01;

/// Sets of terms with a score within this of the best are plausible: two standard errors of one
/// coefficient, squared. statistics/noise_coefficients_test.
constexpr double kPlausibleScore = 4;

// ---- Noise floor ------------------------------------------------------------------------------

/// Means per fitted column of scale factor error: each removes a tenth of the noise's variance, 5 %
/// of the floor. noise_floor_test.
constexpr std::size_t kMeansPerColumn = 10;

/// Standard deviations above which a difference is a spike or a step: one in 2,000 of noise alone.
/// noise_floor_test.
constexpr double kFloorCut = 3.5;

// ---- Which rows are quiet ---------------------------------------------------------------------
/// Largest temperature rate of a soak, degC/min: this, which is 1.2 degC/h, or this fraction of a
/// fast ramp's rate (a quantile of all rows). Chosen: a chamber settles to a few hundredths of its
/// ramp. quiet_rows_test.
constexpr double kMaxQuietRate = 0.02;
constexpr double kQuietShareOfRamps = 0.05;
constexpr double kRampQuantile = 0.95;

/// Fraction of an input's range by which its value is another one. From row to row that is a
/// rotation of the axis or a field that is switched, unless the column is noise. Chosen.
/// quiet_rows_test, outlier_rows_test.
constexpr double kOtherInput = 0.25;
/// The input rate may change within quiet rows by this fraction of its range, or by 0.1 deg/s,
/// which is more than Earth's rate and a reference's noise: a rate table that sweeps makes errors
/// of the scale factor. Chosen. quiet_rows_test.
constexpr double kMaxTurning = 0.01;
constexpr double kMinTurning_dph = 360;

// ---- Noise model ------------------------------------------------------------------------------

/// Periods in a run: slower variations belong to the model, not to the noise. Half or twice the
/// value changes no unit test; tests/bench/hidden_effects, clean gyros.
constexpr double kMinNoisePeriods = 4;

/// Minimum and maximum degrees of freedom of the slow noise. Chosen; above a thousand nothing
/// changes. tests/bench/hidden_effects, clean gyros.
constexpr double kMinFreedom = 3;
constexpr double kMaxDegreesOfFreedom = 1000;

/// Relative to the white variance: smaller components are dropped. A tenth of the variance of white
/// noise in the mean of a day's rows of 10 s. noise_model_test.
constexpr double kNegligibleComponent = 1e-5;

// ---- Noise that differs along a run -----------------------------------------------------------
/// Rows per window, whose noise is known to 19 % (noise_scale.cpp). noise_scale_test.
constexpr std::size_t kScaleWindow = 64;

// ---- Outliers ---------------------------------------------------------------------------------
/// Chauvenet's criterion: rows of noise alone that are expected beyond the limit, which is no less
/// than kRareSigmas. outlier_rows_test.
constexpr double kRowsBeyond = 0.5;

/// In units of the neighbours' scatter: an effect that decays within 2 rows reaches 2.9.
/// outlier_rows_test.
constexpr double kOutlierScatters = 3;

/// Neighbours on either side: three, so that the median ignores one of them, and an event of three
/// rows is found. outlier_rows_test.
constexpr std::size_t kNeighbours = 3;
/// Distance, in rows, within which neighbours with the same inputs are searched for. Chosen.
/// outlier_rows_test.
constexpr std::size_t kNeighbourReach = 20;

/// Rows on either side whose noise is estimated together, to 21 %. outlier_rows_test.
constexpr std::size_t kRowsAround = 25;

// ---- Jumps of quiet stretches, which are events and no slow noise -----------------------------
/// Rows on either side that are compared. jumps_test.
constexpr std::array<Eigen::Index, 4> kJumpWidths{8, 16, 32, 64};
/// Standard deviations of such differences, slow noise included: probability 4e-8 per position.
/// jumps_test.
constexpr double kMinJump = 5.5;
/// Fraction of the jump that half the width must show: a ramp shows half, a jump all. jumps_test.
constexpr double kMinJumpShare = 0.7;

// ---- Values that go together ------------------------------------------------------------------
/// Correlation lengths over which correlations are summed: e^-5 is negligible, and further ones
/// would add scatter. autocorrelation_test.
constexpr double kCorrelationWindow = 5;

}  // namespace fogcomp::noise::rules
