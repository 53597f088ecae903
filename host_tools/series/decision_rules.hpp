#pragma once

/// Every number by which the chain sample -> block -> row decides: its unit, where it comes from,
/// and what looks at the decision. What a gap is stands in recording/decision_rules.hpp.
namespace fogcomp::series::rules {

/// Time constant of the lags that smooth a temperature for Reading::smoothed, relative to the
/// derivative's: an eighth of its noise is left in a rate, and heat that the derivative still
/// follows hardly differs. tests/unit/fit/identify_test.
constexpr double kSmoothing = 2;

}  // namespace fogcomp::series::rules
