#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// A coil between -70 and +130 degC; anything else is a broken sensor.
constexpr Temperature kLeastTemperature = from_integer<Temperature>(-70);
constexpr Temperature kMostTemperature = from_integer<Temperature>(130);
constexpr bool is_possible(Temperature temperature) {
  return temperature >= kLeastTemperature && temperature <= kMostTemperature;
}

/// What a DS18B20 says before its first conversion.
constexpr Temperature kPowerOnReading = from_integer<Temperature>(85);

/// What a reading may be used for.
enum class TemperatureUse : std::uint8_t {
  none,
  good,
  /// The same, but what was used before it was wrong: a history that holds that is none.
  good_anew,
};

/// Finds temperatures that a coil cannot have: missing, impossible, jumping, frozen. It only uses
/// that a coil has a thermal mass (SPEC.md, "Temperature"); DESIGN.md says what that cannot find.
class TemperatureMonitor {
 public:
  /// `sample_period_us` >= 1. The first readings, and those that are far from the last good one,
  /// are confirmed when each has agreed with the one before it for `confirm_us`; where that is 0
  /// the first is at once.
  explicit TemperatureMonitor(std::uint32_t sample_period_us, std::uint32_t confirm_us = 0)
      : sample_period_us_(sample_period_us), confirm_us_(confirm_us) {}

  /// `reading` comes `elapsed` samples after the last one judged; `sensor_valid` is what the
  /// demodulator says of it. Returns what speaks against it.
  Status judge(Temperature reading, bool sensor_valid, std::uint32_t elapsed);

  /// What the reading judged last may be used for.
  TemperatureUse use() const { return use_; }
  /// Whether there was ever a confirmed one. Until then a drift may be computed and not be trusted.
  bool confirmed() const { return started_; }

 private:
  static constexpr Temperature kNoReading = from_integer<Temperature>(-300);  // agrees with none

  Status judge_first(Temperature reading, std::uint32_t elapsed_us);
  bool is_far(Temperature reading) const;
  bool can_be_reached(Temperature reading) const;
  bool jumped(Temperature reading, bool confirmed) const;
  bool is_frozen() const;
  void follow(Temperature reading, std::uint32_t elapsed_us);
  void learn_step(Temperature reading);

  std::uint32_t sample_period_us_;
  std::uint32_t confirm_us_;
  TemperatureUse use_ = TemperatureUse::none;
  bool started_ = false;
  bool frozen_ = false;                  // the last reading
  bool refused_ = false;                 // since the last good one: a reading out of reach
  Temperature last_{};                   // last reading that was neither impossible nor a jump
  Temperature before_ = kNoReading;      // the reading judged before, unless impossible
  std::uint32_t agreed_us_ = 0;          // for which each reading has agreed with the one before it
  std::uint32_t since_last_us_ = 0;      // saturates, as all times here do
  std::uint32_t unchanged_us_ = 0;       // for which the reading has stood
  std::int32_t resolution_ = INT32_MAX;  // smallest step seen, LSB of Temperature
  std::uint32_t large_steps_ = 0;        // far above the resolution, less the others
  std::int32_t moved_ = 0;               // during the one to two minutes before the last step
  std::uint32_t minute_us_ = 0;
  Temperature at_minute_{};  // reading at the start of this minute, of the one before
  Temperature minute_before_{};
};

}  // namespace fog
