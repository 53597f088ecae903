#include "core/frames/kvh_frame.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"
#include "core/bytes/opaque.hpp"
#include "core/fixed_point/fixed.hpp"

namespace fog {
namespace {

constexpr std::uint32_t kHeader = 0xFE81FF55U;
constexpr std::size_t kRotationZ = 12;
constexpr std::size_t kStatus = 28;
constexpr std::size_t kSequence = 29;
constexpr std::size_t kTemperature = 30;
constexpr std::size_t kCrc = 32;
constexpr std::uint8_t kRotationZValid = 1U << 2U;
constexpr std::uint32_t kSequenceMask = 0x7F;

// Decides by the bytes that are sent, not by the variables they were made from. Not inline and
// opaque, so that the compiler cannot replace one by the other.
FOG_OPAQUE std::uint32_t frame_crc(const std::uint8_t* frame, std::uint32_t image_crc) {
  const bool marks_valid = frame[kStatus] != 0;
  return crc32(frame, kCrc, marks_valid ? image_crc : kCrc32Initial);
}

}  // namespace

KvhFrame encode_kvh_frame(Temperature temperature, std::uint32_t rotation, bool valid,
                          std::uint32_t frame_number, std::uint32_t image_crc) {
  KvhFrame frame{};
  store_be32(&frame[0], kHeader);
  store_be32(&frame[kRotationZ], rotation);
  frame[kStatus] = valid ? kRotationZValid : std::uint8_t{0};
  frame[kSequence] = static_cast<std::uint8_t>(frame_number & kSequenceMask);
  const auto whole_degrees = round_to<Fixed<std::int32_t, 0>>(temperature);
  store_be16(&frame[kTemperature], static_cast<std::uint16_t>(whole_degrees.raw()));
  store_be32(&frame[kCrc], frame_crc(frame.data(), image_crc));
  return frame;
}

}  // namespace fog
