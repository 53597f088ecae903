#pragma once

/// All thresholds of the chain sample -> block -> row: unit, origin, and the test that examines the
/// decision. Gaps are defined in recording/decision_rules.hpp.
namespace fogcomp::series::rules {

/// Change of the input rate within a block above which its samples are kept: 0.01 deg/s. Of an
/// error of 1 % at 100 deg/s that goes with W^2 less makes 3e-6 deg/h. signal_series_test.
constexpr double kMinChangeOfRate_dph = 36;

/// Largest change between changes of a signal's second differences, in second differences, without
/// a corner. A sine of nine samples and more a period has less, a corner anywhere within a sample
/// more: two thirds. edge_values_test.
constexpr double kMaxUnevenness = 0.5;

}  // namespace fogcomp::series::rules
