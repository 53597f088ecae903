#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/acquisition/rate_monitor.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {

/// The largest full scale that a board's rate format holds, deg/s.
constexpr double kMaxRangeDps = 582;

/// What a gyro measures and what it is built into can do: a part of its calibration.
struct GyroLimits {
  double range_dps = 570;                 ///< full scale
  double max_acceleration_dps2 = 20'000;  ///< ten times what agile vehicles and rate tables do
};

/// Those of them that were given, in place of others.
struct GivenLimits {
  std::optional<double> range_dps{};
  std::optional<double> max_acceleration_dps2{};

  GyroLimits over(const GyroLimits& others) const {
    return {range_dps.value_or(others.range_dps),
            max_acceleration_dps2.value_or(others.max_acceleration_dps2)};
  }
};

/// In the board's numbers, for samples of this period. A step beyond its format is any step.
inline fog::RateLimits board_limits(const GyroLimits& limits, double period_s) {
  const auto raw = [](double dph, int fraction) {
    return static_cast<std::int32_t>(
        std::clamp(std::round(std::ldexp(dph, fraction)), 1.0, double{INT32_MAX}));
  };
  const double step_dps = limits.max_acceleration_dps2 * period_s;
  return {fog::Rate::from_raw(
              raw(limits.range_dps * kDphPerDegreePerSecond, fog::Rate::fractional_bits)),
          fog::RateStep::from_raw(
              raw(step_dps * kDphPerDegreePerSecond, fog::RateStep::fractional_bits))};
}

/// What a board takes for a temperature.
constexpr double kColdestDegc = -70;
constexpr double kWarmestDegc = 130;

/// What to ask about temperatures of `min` to `max` that lie outside of that.
inline const char* temperature_question(double min, double max) {
  constexpr double kZeroDegcInKelvin = 273.15;
  const bool kelvin =
      min - kZeroDegcInKelvin >= kColdestDegc && max - kZeroDegcInKelvin <= kWarmestDegc;
  return kelvin ? "is temperature_degc in kelvin? subtract 273.15"
                : "is temperature_degc in degC? correct it";
}

/// Longest time without a temperature for which the board keeps its last drift.
constexpr double kHoldSeconds = 60;

}  // namespace fogcomp::recording
