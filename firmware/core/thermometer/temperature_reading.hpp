#pragma once

#include "core/signal/quantities.hpp"

namespace fog {

/// What a thermometer of the board's own says, in place of the sensor stream's temperature.
struct TemperatureReading {
  Temperature temperature{};
  bool valid = false;
};

/// A reading that is older is not valid: three conversions of the slowest sensor may fail before.
constexpr std::uint32_t kOldestReadingMs = 3000;

}  // namespace fog
