#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// Reading of a thermometer on the board, used instead of the sensor stream's temperature.
struct TemperatureReading {
  Temperature temperature{};
  bool valid = false;
};

/// Oldest valid reading: three conversions of the slowest sensor may fail before.
constexpr std::uint32_t kOldestReadingMs = 3000;

/// The last reading of a thermometer, until it is too old.
class LatestReading {
 public:
  void take(TemperatureReading reading, std::uint32_t now_ms) {
    reading_ = reading;
    taken_at_ms_ = now_ms;
  }

  /// Discards a reading that has become too old. To be called regularly: the clock wraps after 49.7
  /// days, and an old reading would become valid again.
  void age(std::uint32_t now_ms) { reading_ = at(now_ms); }

  TemperatureReading at(std::uint32_t now_ms) const {
    return {reading_.temperature, reading_.valid && now_ms - taken_at_ms_ <= kOldestReadingMs};
  }

 private:
  TemperatureReading reading_;
  std::uint32_t taken_at_ms_ = 0;
};

}  // namespace fog
