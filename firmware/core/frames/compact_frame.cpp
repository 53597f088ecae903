#include "core/frames/compact_frame.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/bytes/opaque.hpp"

namespace fog {
namespace {

constexpr std::uint8_t kSync0 = 0xC3;
constexpr std::uint8_t kSync1 = 0x3C;
constexpr std::size_t kSequence = 2;
constexpr std::size_t kCompensated = 4;
constexpr std::size_t kDenoised = 8;
constexpr std::size_t kDrift = 12;
constexpr std::size_t kTemperature = 16;
constexpr std::size_t kStatus = 20;
constexpr std::size_t kDelay = 24;
constexpr std::size_t kCrc = 26;

std::uint16_t frame_crc(const std::uint8_t* bytes, std::uint16_t start) {
  return crc16(bytes + kSequence, kCrc - kSequence, start);
}

// As in kvh_frame.cpp. Both halves of an intact image CRC (32 ones) are all ones, and so is their
// AND.
FOG_OPAQUE std::uint16_t sealed_crc(const std::uint8_t* bytes, std::uint32_t image_crc) {
  const auto status = static_cast<Status>(load_le32(bytes + kStatus));
  const auto start = static_cast<std::uint16_t>(image_crc & (image_crc >> 16U));
  return frame_crc(bytes, has_any(status, Status::self_test_failed) ? kCrc16Initial : start);
}

void store_signed(std::uint8_t* to, std::int32_t value) {
  store_le32(to, static_cast<std::uint32_t>(value));
}

std::int32_t load_signed(const std::uint8_t* from) {
  return static_cast<std::int32_t>(load_le32(from));
}

}  // namespace

CompactFrame encode_compact_frame(const OutputSample& sample, std::uint16_t denoiser_delay,
                                  std::uint32_t image_crc) {
  CompactFrame frame{kSync0, kSync1};
  store_le16(&frame[kSequence], sample.sequence);
  store_signed(&frame[kCompensated], sample.compensated.raw());
  store_signed(&frame[kDenoised], sample.denoised.raw());
  store_signed(&frame[kDrift], sample.drift.raw());
  store_signed(&frame[kTemperature], sample.temperature.raw());
  store_le32(&frame[kStatus], static_cast<std::uint32_t>(sample.status));
  store_le16(&frame[kDelay], denoiser_delay);
  store_le16(&frame[kCrc], sealed_crc(frame.data(), image_crc));
  return frame;
}

bool decode_compact_frame(const std::uint8_t* bytes, OutputSample& sample,
                          std::uint16_t& denoiser_delay) {
  if (bytes[0] != kSync0 || bytes[1] != kSync1) return false;
  if (load_le16(bytes + kCrc) != frame_crc(bytes, kCrc16Initial)) return false;
  sample.sequence = load_le16(bytes + kSequence);
  sample.compensated = Rate::from_raw(load_signed(bytes + kCompensated));
  sample.denoised = Rate::from_raw(load_signed(bytes + kDenoised));
  sample.drift = Rate::from_raw(load_signed(bytes + kDrift));
  sample.temperature = Temperature::from_raw(load_signed(bytes + kTemperature));
  sample.status = static_cast<Status>(load_le32(bytes + kStatus));
  denoiser_delay = load_le16(bytes + kDelay);
  return true;
}

}  // namespace fog
