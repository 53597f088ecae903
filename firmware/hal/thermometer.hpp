#pragma once

#include <cstdint>

namespace fog::hal {

// A board's own thermometer on the coil, in images that are built with one (FOG_TEMPERATURE); else
// the temperature is the sensor stream's and nothing of this exists.

struct OwnTemperature {
  std::int32_t temperature_q16;  ///< degC, LSB 2^-16
  bool valid;                    ///< measured within the last seconds by a sensor that works
};

/// Once, after the board has been started.
void start_thermometer();

/// Takes the measurement one step on. Never waits; wants to be called once a millisecond or more.
void advance_thermometer();

/// The last reading.
OwnTemperature own_temperature();

}  // namespace fog::hal
