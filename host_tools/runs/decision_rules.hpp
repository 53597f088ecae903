#pragma once

#include <array>

/// All numbers that decide in which rows runs are looked at: unit, origin, and the test that
/// examines the decision (in tests/unit/runs unless a folder is named).
namespace fogcomp::runs::rules {

// ---- In which rows? ---------------------------------------------------------------------------
/// Row lengths of verdicts, seconds: the first with at most kMaxRowsToJudge rows is used. Means
/// over 10 s preserve all temperature effects of the catalogue; the thresholds of fit and diagnosis
/// were set with such rows (tests/bench/hidden_effects). The longest is for months.
/// row_length_test.
constexpr std::array<double, 8> kRowLengths_s{10, 20, 30, 60, 120, 300, 600, 1800};
constexpr double kMaxRowsToJudge = 12000;
/// Two rows for each of the 50 stretches that a cross-validation may leave out: with fewer the
/// model's own rows are used, if they are shorter. row_length_test.
constexpr double kMinRowsToJudge = 100;

// ---- Are rows short enough? -------------------------------------------------------------------
/// A note says that rows average soaks and ramps together where much of the time is in segments of
/// fewer rows: a segment of two rows always contains a whole one. tests/integration/bad_input.sh.
constexpr double kShortSegmentRows = 2;

// ---- Are they of one gyro? --------------------------------------------------------------------
/// Ratio of the noise floors of two runs from which on they are hardly of one gyro: noise changes
/// with temperature and light by less. workbench/session_test.
constexpr double kMaxNoiseRatio = 3;

}  // namespace fogcomp::runs::rules
