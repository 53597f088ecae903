#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// One raw, uncalibrated sample from the demodulator (SPEC.md, "Sensor stream").
struct SensorSample {
  std::uint16_t sequence = 0;
  std::int32_t rate_counts = 0;
  std::int32_t temperature_q16 = 0;  ///< degC, LSB 2^-16
  bool gyro_valid = false;
  bool temperature_valid = false;
};

constexpr std::size_t kSensorFrameBytes = 16;
constexpr std::uint8_t kSensorSync0 = 0xA5;
constexpr std::uint8_t kSensorSync1 = 0x5A;
using SensorFrame = std::array<std::uint8_t, kSensorFrameBytes>;

/// Encodes a sample: 16 bytes, CRC included. For the host's streams and tests.
SensorFrame encode_sensor_frame(const SensorSample& sample);

/// Reads 16 bytes. Returns false, and leaves `sample` unchanged, unless sync, CRC, reserved byte
/// and unused status bits are valid.
bool decode_sensor_frame(const std::uint8_t* bytes, SensorSample& sample);

}  // namespace fog
