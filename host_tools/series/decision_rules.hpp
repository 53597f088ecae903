#pragma once

/// All thresholds of the chain sample -> block -> row: unit, origin, and the test that examines the
/// decision. Gaps are defined in recording/decision_rules.hpp.
namespace fogcomp::series::rules {

/// Time constant of the lags that smooth a temperature for Reading::smoothed, relative to the
/// derivative's: an eighth of the noise remains in a rate, and heat that the derivative follows is
/// hardly changed. tests/unit/fit/identify_test.
constexpr double kSmoothing = 2;

}  // namespace fogcomp::series::rules
