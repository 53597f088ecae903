#pragma once

#include <cstddef>

/// Every number by which it is judged what a model leaves on a recording, and how a recording looks
/// without a model: its unit, where it comes from, and what looks at the decision (a test of
/// tests/unit/compare unless a folder is named). What only draws (bins of a curve) stands where it
/// is used.
namespace fogcomp::compare::rules {

// ---- On what does a residual depend? ----------------------------------------------------------
/// Standard score from which a dependence is said: reached in 1, 0 and 5 of 300 simulated runs
/// without any over temperature, rate and history, in 20 over time (dependence.hpp).
/// dependence_test.
constexpr double kStructured = 5;
/// Rows of a class that counts: its mean's error is known to a third. dependence_test.
constexpr std::size_t kMinInClass = 5;
/// Rows from which anything is said at all: ten classes of five. residual_analysis_test.
constexpr std::size_t kMinRowsToJudge = 50;

/// Standard deviations of the floor's own error, 0.6 / sqrt(rows), within which a residual is at
/// the floor. residual_analysis_test.
constexpr double kFloorErrorSigmas = 4;

/// Share of the error by which two figures differ that are worth printing both: what the board's
/// delay makes. tests/integration/equal_figures.sh.
constexpr double kTellsApart = 0.01;

/// Of an input's size: what changes by less is its rounding. comparison_test.
constexpr double kStandsStill = 1e-9;

// ---- Which way did the temperature go last? ---------------------------------------------------
/// Play between heating and cooling, degC: beyond a digital sensor's resolution and noise, or this
/// share of the range. Chosen. dependence_test.
constexpr double kMinPlayDegc = 0.5;
constexpr double kPlayShareOfRange = 0.02;

// ---- Temperature sensitivities of a recording by itself ---------------------------------------
/// Range over which a slope or a loop means something, degC. Chosen. temperature_sensitivity_test.
constexpr double kMinRangeDegc = 5;
/// Variance inflation beyond which the other columns imitate a rate term: correlation 0.99.
/// temperature_sensitivity_test.
constexpr double kMaxVarianceInflation = 50;
/// Rows on each branch of a bin. temperature_sensitivity_test.
constexpr std::size_t kMinRowsOnBranch = 3;

// ---- Is a row within what the model was trained on? -------------------------------------------
/// Margin of the trained rates, share of their range, and at least, degC/min: sensor noise, and the
/// last percent of a chamber's control. trained_range_test.
constexpr double kRateMargin = 0.05;
constexpr double kMinRateMarginDegcPerMin = 0.02;

// ---- Are rows short enough? -------------------------------------------------------------------
/// Share of the time in segments of less than so many rows from which it is said that rows average
/// soaks and ramps together: a segment of two rows has a whole one in it however they lie.
/// tests/integration/bad_input.sh.
constexpr double kMinShareOfShortSegments = 0.1;
constexpr double kShortSegmentRows = 2;

}  // namespace fogcomp::compare::rules
