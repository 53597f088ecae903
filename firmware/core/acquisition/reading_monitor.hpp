#pragma once

#include <cstdint>
#include <type_traits>

#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// A coil between -70 and +130 degC; anything else is a broken sensor.
constexpr Temperature kMinTemperature = from_integer<Temperature>(-70);
constexpr Temperature kMaxTemperature = from_integer<Temperature>(130);
constexpr bool is_possible(Temperature temperature) {
  return temperature >= kMinTemperature && temperature <= kMaxTemperature;
}

/// What a DS18B20 says before its first conversion.
constexpr Temperature kPowerOnReading = from_integer<Temperature>(85);

/// A coil in its housing follows the worst thermal shock by tenths of a degree a second. So 1 degC
/// a second since the last good reading, and this for the sensor's own noise and resolution.
constexpr Temperature kTemperatureStep = from_integer<Temperature>(2);

/// What a reading may be used for.
enum class ReadingUse : std::uint8_t {
  none,
  good,
  /// The same, but what was used before it was wrong: a history that holds that is none.
  good_anew,
};

/// The coil's own temperature, whatever the model.
struct CoilLimits {
  static constexpr Temperature min = kMinTemperature;
  static constexpr Temperature max = kMaxTemperature;
  static constexpr Temperature step = kTemperatureStep;
  static constexpr bool has_thermal_mass = true;
};

/// An input of extension records, from the model table.
struct InputLimits {
  ExtensionValue min{};   ///< what is below it cannot be
  ExtensionValue max{};   ///< ... above it
  ExtensionValue step{};  ///< a larger change has to be confirmed
  bool has_thermal_mass = false;
};

/// Finds readings that a sensor cannot have measured: missing, impossible, jumping, frozen. Of a
/// temperature it uses that a coil has a thermal mass; any other quantity may be anything soon,
/// but not for a single reading (SPEC.md, "Judging a sample"). DESIGN.md says what that cannot
/// find.
template <class Limits>
class ReadingMonitor : private Limits {
 public:
  using Reading = Temperature;
  static_assert(std::is_same_v<Reading, ExtensionValue>);

  /// `sample_period_us` >= 1. The first readings, and those that are far from the last good one,
  /// are confirmed when each has agreed with the one before it for `confirm_us`; where that is 0
  /// the first is at once.
  explicit ReadingMonitor(std::uint32_t sample_period_us, std::uint32_t confirm_us = 0,
                          const Limits& limits = {})
      : Limits(limits), sample_period_us_(sample_period_us), confirm_us_(confirm_us) {}

  /// `reading` comes `elapsed` samples after the last one judged; `sensor_valid` is what the
  /// demodulator says of it. Returns what speaks against it, as flags of a temperature.
  Status judge(Reading reading, bool sensor_valid, std::uint32_t elapsed);

  /// Takes this for a confirmed reading, before the first one is judged.
  void resume(Reading reading) { follow(reading, 0); }

  /// What the reading judged last may be used for.
  ReadingUse use() const { return use_; }
  /// Whether there was ever a confirmed one. Until then a drift may be computed and not be trusted.
  bool confirmed() const { return started_; }

 private:
  static constexpr Reading kNoReading = Reading::lowest();  // agrees with none that is possible

  Status judge_first(Reading reading, std::uint32_t elapsed_us);
  bool is_power_on_reading(Reading reading) const;
  bool is_step(Reading a, Reading b) const;
  bool can_be_reached(Reading reading) const;
  bool jumped(Reading reading, bool confirmed) const;
  bool is_frozen() const;
  void follow(Reading reading, std::uint32_t elapsed_us);
  void learn_step(Reading reading);

  std::uint32_t sample_period_us_;
  std::uint32_t confirm_us_;
  ReadingUse use_ = ReadingUse::none;
  bool started_ = false;
  bool frozen_ = false;                    // the last reading
  bool refused_ = false;                   // since the last good one: a reading out of reach
  Reading last_{};                         // last reading that was neither impossible nor a jump
  Reading before_ = kNoReading;            // the reading judged before, unless impossible
  std::uint32_t agreed_us_ = 0;            // for which each reading has agreed with the one before
  std::uint32_t since_last_us_ = 0;        // saturates, as all times here do
  std::uint32_t unchanged_us_ = 0;         // for which the reading has stood
  std::uint32_t resolution_ = UINT32_MAX;  // smallest step seen, LSB of Reading
  std::uint32_t large_steps_ = 0;          // far above the resolution, less the others
  std::uint32_t moved_ = 0;                // during the one to two minutes before the last step
  std::uint32_t minute_us_ = 0;
  Reading at_minute_{};  // reading at the start of this minute, of the one before
  Reading minute_before_{};
};

using TemperatureMonitor = ReadingMonitor<CoilLimits>;
using InputMonitor = ReadingMonitor<InputLimits>;

}  // namespace fog
