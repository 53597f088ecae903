#include "core/frames/health_record.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"

namespace fog {
namespace {

constexpr std::uint8_t kSync0 = 0xC3;
constexpr std::uint8_t kSync1 = 0x99;
constexpr std::uint8_t kLayout = 4;
constexpr std::uint8_t kLayoutWithoutFilter = 3;  // 0 where the filter is now

constexpr std::size_t kLayoutAt = 2;
constexpr std::size_t kFlags = 3;
constexpr std::size_t kWords = 4;
constexpr std::size_t kSerialEnd = kWords + 4 * static_cast<std::size_t>(HealthWord::count) - 1;
constexpr std::size_t kResetCause = kSerialEnd + 1;
constexpr std::size_t kResetCauseEnd = kResetCause + 15;
constexpr std::size_t kCrc = kResetCauseEnd + 1;
static_assert(kCrc + 4 == kHealthResponseBytes);

constexpr unsigned kImageIntact = 1U << 0U;
constexpr unsigned kMemoryGood = 1U << 1U;
constexpr unsigned kModelErrorShift = 4;
constexpr unsigned kUnusedFlags = 0x0C;

}  // namespace

HealthResponse encode_health_response(const HealthRecord& record) {
  HealthResponse response{kSync0, kSync1, kLayout};
  response[kFlags] = static_cast<std::uint8_t>((record.image_intact ? kImageIntact : 0U) |
                                               (record.memory_good ? kMemoryGood : 0U) |
                                               unsigned{record.model_error} << kModelErrorShift);
  for (std::size_t i = 0; i < record.words.size(); ++i) {
    store_le32(&response[kWords + 4 * i], record.words[i]);
  }
  for (std::size_t i = 0; i < record.reset_cause.size(); ++i) {
    response[kResetCause + i] = static_cast<std::uint8_t>(record.reset_cause[i]);
  }
  store_le32(&response[kCrc], crc32(response.data(), kCrc));
  return response;
}

bool decode_health_response(const std::uint8_t* bytes, HealthRecord& record) {
  const std::uint8_t layout = bytes[kLayoutAt];
  if (bytes[0] != kSync0 || bytes[1] != kSync1) return false;
  if (layout != kLayout && layout != kLayoutWithoutFilter) return false;
  if (load_le32(bytes + kCrc) != crc32(bytes, kCrc)) return false;
  const bool texts_end = bytes[kSerialEnd] == 0 && bytes[kResetCauseEnd] == 0;
  if ((bytes[kFlags] & kUnusedFlags) != 0U || !texts_end) return false;
  record.image_intact = (bytes[kFlags] & kImageIntact) != 0U;
  record.memory_good = (bytes[kFlags] & kMemoryGood) != 0U;
  record.model_error = static_cast<std::uint8_t>(bytes[kFlags] >> kModelErrorShift);
  for (std::size_t i = 0; i < record.words.size(); ++i) {
    record.words[i] = load_le32(bytes + kWords + 4 * i);
  }
  for (std::size_t i = 0; i < record.reset_cause.size(); ++i) {
    record.reset_cause[i] = static_cast<char>(bytes[kResetCause + i]);
  }
  return true;
}

}  // namespace fog
