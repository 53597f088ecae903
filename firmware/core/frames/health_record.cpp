#include "core/frames/health_record.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"

namespace fog {
namespace {

constexpr std::uint8_t kSync0 = 0xC3;
constexpr std::uint8_t kSync1 = 0x99;
constexpr std::uint8_t kLayout = 1;

constexpr std::size_t kLayoutAt = 2;
constexpr std::size_t kFlags = 3;
constexpr std::size_t kWords = 4;  // the 32-bit fields, in order
constexpr std::size_t kStackBytes = 44;
constexpr std::size_t kStackUnused = 46;
constexpr std::size_t kResetCause = 48;
constexpr std::size_t kCrc = 64;

constexpr unsigned kImageIntact = 1U << 0U;
constexpr unsigned kMemoryGood = 1U << 1U;
constexpr unsigned kModelGood = 1U << 2U;
constexpr unsigned kAllFlags = kImageIntact | kMemoryGood | kModelGood;

}  // namespace

HealthResponse encode_health_response(const HealthRecord& record) {
  HealthResponse response{kSync0, kSync1, kLayout};
  response[kFlags] = static_cast<std::uint8_t>((record.image_intact ? kImageIntact : 0U) |
                                               (record.memory_good ? kMemoryGood : 0U) |
                                               (record.model_good ? kModelGood : 0U));
  std::size_t at = kWords;
  for (const std::uint32_t word :
       {record.model, record.image_crc, record.samples, record.invalid_rates, record.sequence_gaps,
        record.discarded_bytes, static_cast<std::uint32_t>(record.status_last),
        static_cast<std::uint32_t>(record.status_seen), record.image_passes,
        record.memory_passes}) {
    store_le32(&response[at], word);
    at += 4;
  }
  store_le16(&response[kStackBytes], record.stack_bytes);
  store_le16(&response[kStackUnused], record.stack_unused_bytes);
  for (std::size_t i = 0; i < record.reset_cause.size(); ++i) {
    response[kResetCause + i] = static_cast<std::uint8_t>(record.reset_cause[i]);
  }
  store_le32(&response[kCrc], crc32(response.data(), kCrc));
  return response;
}

bool decode_health_response(const std::uint8_t* bytes, HealthRecord& record) {
  if (bytes[0] != kSync0 || bytes[1] != kSync1 || bytes[kLayoutAt] != kLayout) return false;
  if (load_le32(bytes + kCrc) != crc32(bytes, kCrc)) return false;
  const bool cause_ends = bytes[kResetCause + record.reset_cause.size() - 1] == 0;
  if ((bytes[kFlags] & ~kAllFlags) != 0U || !cause_ends) return false;
  record.image_intact = (bytes[kFlags] & kImageIntact) != 0U;
  record.memory_good = (bytes[kFlags] & kMemoryGood) != 0U;
  record.model_good = (bytes[kFlags] & kModelGood) != 0U;
  const std::uint8_t* at = bytes + kWords;
  const auto next = [&at] {
    const std::uint32_t word = load_le32(at);
    at += 4;
    return word;
  };
  for (std::uint32_t* word :
       {&record.model, &record.image_crc, &record.samples, &record.invalid_rates,
        &record.sequence_gaps, &record.discarded_bytes}) {
    *word = next();
  }
  record.status_last = static_cast<Status>(next());
  record.status_seen = static_cast<Status>(next());
  record.image_passes = next();
  record.memory_passes = next();
  record.stack_bytes = load_le16(bytes + kStackBytes);
  record.stack_unused_bytes = load_le16(bytes + kStackUnused);
  for (std::size_t i = 0; i < record.reset_cause.size(); ++i) {
    record.reset_cause[i] = static_cast<char>(bytes[kResetCause + i]);
  }
  return true;
}

}  // namespace fog
