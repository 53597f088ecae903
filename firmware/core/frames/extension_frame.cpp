#include "core/frames/extension_frame.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/frames/sensor_frame.hpp"

namespace fog {
namespace {

constexpr std::size_t kType = 1;
constexpr std::size_t kInput = 2;
constexpr std::size_t kReserved = 3;
constexpr std::size_t kValue = 4;
constexpr std::size_t kCrc = 8;

std::uint16_t frame_crc(const std::uint8_t* bytes) {
  return crc16(bytes + kType, kCrc - kType);
}

}  // namespace

ExtensionFrame encode_extension_frame(const ExtensionRecord& record) {
  ExtensionFrame frame{kSensorSync0, kExtensionSync1,
                       static_cast<std::uint8_t>(extension_number(record.input))};
  store_le32(&frame[kValue], static_cast<std::uint32_t>(record.value.raw()));
  store_le16(&frame[kCrc], frame_crc(frame.data()));
  return frame;
}

bool decode_extension_frame(const std::uint8_t* bytes, ExtensionRecord& record) {
  if (bytes[0] != kSensorSync0 || bytes[kType] != kExtensionSync1) return false;
  if (load_le16(bytes + kCrc) != frame_crc(bytes)) return false;
  if (bytes[kReserved] != 0U || bytes[kInput] >= kExtensionInputs) return false;
  record.input = extension_input(bytes[kInput]);
  record.value = ExtensionValue::from_raw(static_cast<std::int32_t>(load_le32(bytes + kValue)));
  return true;
}

}  // namespace fog
