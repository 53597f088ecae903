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

/// Register value of a DS18B20 before its first conversion.
constexpr Temperature kPowerOnReading = from_integer<Temperature>(85);

/// In the worst thermal shock a coil in its housing changes by tenths of a degree per second.
/// Allowed: 1 degC per second since the last good reading, and this step for the sensor's noise and
/// resolution.
constexpr Temperature kTemperatureStep = from_integer<Temperature>(2);

/// Use that may be made of a reading.
enum class ReadingUse : std::uint8_t {
  none,
  good,
  /// Good, but readings used before it were wrong: the history built on them must be discarded.
  good_new_history,
};

/// Limits of the coil temperature, the same for every model.
struct CoilLimits {
  static constexpr Temperature min = kMinTemperature;
  static constexpr Temperature max = kMaxTemperature;
  static constexpr Temperature step = kTemperatureStep;
  static constexpr bool has_thermal_mass = true;
};

/// Limits of an extension input, from the model table.
struct InputLimits {
  ExtensionValue min{};   ///< lowest possible value
  ExtensionValue max{};   ///< highest possible value
  ExtensionValue step{};  ///< a larger change has to be confirmed
  bool has_thermal_mass = false;
};

/// Finds readings that a sensor cannot have measured: missing, impossible, jumping, frozen. For a
/// temperature it relies on the thermal mass of the coil. Any other quantity may change at any
/// speed, but not for a single reading (spec/samples.md). DESIGN.md lists the faults
/// that this cannot find.
template <class Limits>
class ReadingMonitor : private Limits {
 public:
  using Reading = Temperature;
  static_assert(std::is_same_v<Reading, ExtensionValue>);

  /// `sample_period_us` >= 1. The first readings, and readings far from the last good one, are
  /// confirmed after each of them agreed with its predecessor for `confirm_us`. With 0 the first
  /// reading is confirmed at once.
  explicit ReadingMonitor(std::uint32_t sample_period_us, std::uint32_t confirm_us = 0,
                          const Limits& limits = {})
      : Limits(limits), sample_period_us_(sample_period_us), confirm_us_(confirm_us) {}

  /// `reading` comes `elapsed` samples after the last one judged; `sensor_valid` is the
  /// demodulator's flag. Returns the faults found, as flags of a temperature.
  Status judge(Reading reading, bool sensor_valid, std::uint32_t elapsed);

  /// Takes `reading` as confirmed. To be called before the first reading is judged.
  void resume(Reading reading) { follow(reading, 0); }

  /// Use that may be made of the reading judged last.
  ReadingUse use() const { return use_; }
  /// Whether a reading has been confirmed. Before that a drift may be computed but must not be
  /// trusted.
  bool confirmed() const { return started_; }

 private:
  static constexpr Reading kNoReading = Reading::lowest();  // agrees with no possible reading

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
  bool refused_ = false;                   // a reading was refused since the last good one
  Reading last_{};                         // last reading that was possible and no jump
  Reading before_ = kNoReading;            // reading before this one; kNoReading if impossible
  std::uint32_t agreed_us_ = 0;            // time for which consecutive readings have agreed
  std::uint32_t since_last_us_ = 0;        // saturates, like all times here
  std::uint32_t unchanged_us_ = 0;         // time since the reading last changed
  std::uint32_t resolution_ = UINT32_MAX;  // smallest step seen, LSB of Reading
  std::uint32_t large_steps_ = 0;          // steps far above the resolution, less the other steps
  std::uint32_t moved_ = 0;                // change in the one to two minutes before the last step
  std::uint32_t minute_us_ = 0;
  Reading at_minute_{};  // reading at the start of this minute, of the one before
  Reading minute_before_{};
};

using TemperatureMonitor = ReadingMonitor<CoilLimits>;
using InputMonitor = ReadingMonitor<InputLimits>;

}  // namespace fog
