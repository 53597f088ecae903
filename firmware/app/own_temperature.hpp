#pragma once

#include "core/frames/sensor_frame.hpp"
#include "hal/thermometer.hpp"

namespace fog::app {

/// Whether the board measures the temperature itself (FOG_TEMPERATURE of the build). If not, this
/// code takes neither flash nor time.
constexpr bool kOwnThermometer = FOG_OWN_THERMOMETER != 0;

inline void start_own_thermometer() {
  if constexpr (kOwnThermometer) hal::start_thermometer();
}

inline void advance_own_thermometer() {
  if constexpr (kOwnThermometer) hal::advance_thermometer();
}

/// The sample with the board's own temperature, if it has one, instead of the stream's.
inline decltype(auto) with_own_temperature(const SensorSample& sample) {
  if constexpr (kOwnThermometer) {
    const hal::OwnTemperature own = hal::own_temperature();
    return SensorSample{sample.sequence, sample.rate_counts, own.temperature_q16, sample.gyro_valid,
                        own.valid};
  } else {
    return (sample);
  }
}

}  // namespace fog::app
