#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/acquisition/rate_monitor.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {

/// The largest full scale that a board's rate format holds, deg/s. With 9 fractional bits `Rate`
/// (`core/signal/quantities.hpp`) would end at 1165 deg/s. The bounds of
/// `scale_factor_nonlinearity`, the compact frame and the vectors of `tests/golden` would change.
constexpr double kMaxRangeDps = 582;

/// Limits of the gyro and of the vehicle: a part of the calibration.
struct GyroLimits {
  double range_dps = 570;                 ///< full scale
  double max_acceleration_dps2 = 20'000;  ///< ten times what agile vehicles and rate tables do
};

/// Limits that were given; the others keep their values.
struct GivenLimits {
  std::optional<double> range_dps{};
  std::optional<double> max_acceleration_dps2{};

  GyroLimits over(const GyroLimits& others) const {
    return {range_dps.value_or(others.range_dps),
            max_acceleration_dps2.value_or(others.max_acceleration_dps2)};
  }
};

/// The limits in the board's formats, for samples of this period. A step beyond its format is
/// unlimited.
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

/// Lowest temperature that a board accepts, degC.
constexpr double kColdestDegc = -70;
constexpr double kWarmestDegc = 130;

/// Question for a recording with temperatures from `min` to `max` outside the board's range.
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
