#pragma once

namespace fogcomp {

/// Full scale of a board's rate, deg/s: of the rate format's 582.
constexpr double kRangeDegPerS = 570;

/// Longest time without a temperature for which the board keeps its last drift.
constexpr double kHoldSeconds = 60;

}  // namespace fogcomp
