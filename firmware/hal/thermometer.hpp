#pragma once

#include <cstdint>

namespace fog::hal {

// A thermometer of the board on the coil, only in images built with one (FOG_TEMPERATURE). Other
// images use the temperature of the sensor stream.

struct OwnTemperature {
  std::int32_t temperature_q16;  ///< degC, LSB 2^-16
  bool valid;                    ///< measured within the last seconds by a working sensor
};

/// To be called once, after start_board().
void start_thermometer();

/// Advances the measurement. Never waits; to be called at least once per millisecond.
void advance_thermometer();

/// The last reading.
OwnTemperature own_temperature();

}  // namespace fog::hal
