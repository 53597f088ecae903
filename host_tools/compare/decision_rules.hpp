#pragma once

#include <cstddef>

/// All thresholds for judging a model's residual and a recording without a model: unit, origin, and
/// the test that examines the decision (in tests/unit/compare unless a folder is named). Constants
/// of plots only are next to their use.
namespace fogcomp::compare::rules {

// ---- On what does a residual depend? ----------------------------------------------------------
/// Smallest number of rows of a class: its mean's error is known to a third. dependence_test.
constexpr std::size_t kMinInClass = 5;
/// Smallest number of rows for any statement: ten classes of five. residual_analysis_test.
constexpr std::size_t kMinRowsToJudge = 50;

/// Relative difference of two errors (with and without the board's delay) above which both are
/// printed. tests/integration/equal_figures.sh.
constexpr double kTellsApart = 0.01;

/// Relative to an input's size: smaller changes are rounding. comparison_test.
constexpr double kStandsStill = 1e-9;

// ---- Heating or cooling branch ----------------------------------------------------------------
/// Play between heating and cooling, degC: above a digital sensor's resolution and noise; or this
/// fraction of the range. Chosen. dependence_test.
constexpr double kMinPlayDegc = 0.5;
constexpr double kPlayShareOfRange = 0.02;

// ---- Temperature sensitivities of a recording by itself ---------------------------------------
/// Smallest temperature range for a slope or a loop, degC. Chosen. temperature_sensitivity_test.
constexpr double kMinRangeDegc = 5;
/// Variance inflation above which the other columns imitate a rate term: correlation 0.99.
/// temperature_sensitivity_test.
constexpr double kMaxVarianceInflation = 50;
/// Smallest number of rows on each branch of a bin. temperature_sensitivity_test.
constexpr std::size_t kMinRowsOnBranch = 3;

// ---- Is a row within what the model was trained on? -------------------------------------------
/// Margin of the trained rates, as a fraction of their range, beside that of a soak; covers sensor
/// noise and the chamber's control error. trained_range_test.
constexpr double kRateMargin = 0.05;

}  // namespace fogcomp::compare::rules
