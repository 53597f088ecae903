#pragma once

namespace fogcomp {

/// Full scale of a board's rate, deg/s: of the rate format's 582.
constexpr double kRangeDegPerS = 570;

/// What a board takes for a temperature.
constexpr double kColdestDegc = -70;
constexpr double kWarmestDegc = 130;

/// What to ask about temperatures of `least` to `most` that lie outside of that.
inline const char* temperature_question(double least, double most) {
  constexpr double kZeroDegcInKelvin = 273.15;
  const bool kelvin =
      least - kZeroDegcInKelvin >= kColdestDegc && most - kZeroDegcInKelvin <= kWarmestDegc;
  return kelvin ? "is temperature_degc in kelvin? subtract 273.15"
                : "is temperature_degc in degC? correct it";
}

/// Longest time without a temperature for which the board keeps its last drift.
constexpr double kHoldSeconds = 60;

}  // namespace fogcomp
