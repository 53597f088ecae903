#pragma once

#include <cstdint>

#include "core/frames/sensor_frame.hpp"
#include "emulated_board.hpp"

namespace fogcomp::injection {

/// Sensor stream of a healthy gyro at rest.
class HealthyStream {
 public:
  Bytes next(int samples) {
    Bytes bytes;
    for (int i = 0; i < samples; ++i) {
      noise_ = noise_ * 1664525U + 1013904223U;
      const auto counts = static_cast<std::int32_t>(noise_ >> 20U) - 2048;
      const fog::SensorFrame frame =
          fog::encode_sensor_frame({++sequence_, counts, 25 * 65536, true, true});
      bytes.insert(bytes.end(), frame.begin(), frame.end());
    }
    return bytes;
  }

 private:
  std::uint16_t sequence_ = 0;
  std::uint32_t noise_ = 1;
};

}  // namespace fogcomp::injection
