#include "core/frames/sensor_frame.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"

namespace fog {
namespace {

constexpr std::size_t kSequence = 2;
constexpr std::size_t kRate = 4;
constexpr std::size_t kTemperature = 8;
constexpr std::size_t kStatus = 12;
constexpr std::size_t kReserved = 13;
constexpr std::size_t kCrc = 14;

constexpr std::uint8_t kGyroValid = 1U << 0U;
constexpr std::uint8_t kTemperatureValid = 1U << 1U;

std::uint16_t frame_crc(const std::uint8_t* bytes) {
  return crc16(bytes + kSequence, kCrc - kSequence);
}

}  // namespace

SensorFrame encode_sensor_frame(const SensorSample& sample) {
  SensorFrame frame{kSensorSync0, kSensorSync1};
  store_le16(&frame[kSequence], sample.sequence);
  store_le32(&frame[kRate], static_cast<std::uint32_t>(sample.rate_counts));
  store_le32(&frame[kTemperature], static_cast<std::uint32_t>(sample.temperature_q16));
  frame[kStatus] = static_cast<std::uint8_t>((sample.gyro_valid ? kGyroValid : 0U) |
                                             (sample.temperature_valid ? kTemperatureValid : 0U));
  store_le16(&frame[kCrc], frame_crc(frame.data()));
  return frame;
}

bool decode_sensor_frame(const std::uint8_t* bytes, SensorSample& sample) {
  if (bytes[0] != kSensorSync0 || bytes[1] != kSensorSync1) return false;
  if (load_le16(bytes + kCrc) != frame_crc(bytes)) return false;
  if (bytes[kReserved] != 0U) return false;
  const std::uint8_t status = bytes[kStatus];
  if ((status & ~(kGyroValid | kTemperatureValid)) != 0U) return false;
  sample.sequence = load_le16(bytes + kSequence);
  sample.rate_counts = static_cast<std::int32_t>(load_le32(bytes + kRate));
  sample.temperature_q16 = static_cast<std::int32_t>(load_le32(bytes + kTemperature));
  sample.gyro_valid = (status & kGyroValid) != 0U;
  sample.temperature_valid = (status & kTemperatureValid) != 0U;
  return true;
}

}  // namespace fog
