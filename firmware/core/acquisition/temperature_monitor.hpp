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

/// Finds temperatures that a coil cannot have: missing, impossible, jumping, frozen. It only uses
/// that a coil has a thermal mass (SPEC.md, "Temperature"); DESIGN.md says what that cannot find.
class TemperatureMonitor {
 public:
  /// `sample_period_us` >= 1.
  explicit TemperatureMonitor(std::uint32_t sample_period_us)
      : sample_period_us_(sample_period_us) {}

  /// `reading` comes `elapsed` samples after the last one judged; `sensor_valid` is what the
  /// demodulator says of it. A reading against which nothing is returned may be used.
  Status judge(Temperature reading, bool sensor_valid, std::uint32_t elapsed);

 private:
  bool jumped(Temperature reading) const;
  bool frozen() const;
  void follow(Temperature reading, std::uint32_t elapsed_us);
  void learn_step(Temperature reading);

  std::uint32_t sample_period_us_;
  bool started_ = false;
  Temperature last_{};                   // last reading that was neither impossible nor a jump
  Temperature before_{};                 // the reading judged before, unless impossible
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
