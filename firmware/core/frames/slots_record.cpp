#include "core/frames/slots_record.hpp"

#include "core/bytes/byte_order.hpp"
#include "core/bytes/crc.hpp"

namespace fog {
namespace {

// C3 9A | layout | used | for each slot: error, 0 0 0, sequence, model, table, serial | CRC-32
constexpr std::uint8_t kSync0 = 0xC3;
constexpr std::uint8_t kSync1 = 0x9A;
constexpr std::uint8_t kLayout = 1;
constexpr std::size_t kUsedAt = 3;
constexpr std::size_t kSlotsAt = 4;
constexpr std::size_t kSlotBytes = 32;
constexpr std::size_t kSequenceAt = 4;
constexpr std::size_t kModelAt = 8;
constexpr std::size_t kTableAt = 12;
constexpr std::size_t kSerialAt = 16;
constexpr std::size_t kCrcAt = kSlotsAt + 2 * kSlotBytes;
static_assert(kCrcAt + 4 == kSlotsResponseBytes);

SlotRecord slot_at(const std::uint8_t* bytes) {
  SlotRecord slot{bytes[0],
                  load_le32(bytes + kSequenceAt),
                  load_le32(bytes + kModelAt),
                  load_le32(bytes + kTableAt),
                  {}};
  for (std::size_t i = 0; i < slot.serial.size(); ++i) {
    slot.serial[i] = load_le32(bytes + kSerialAt + 4 * i);
  }
  return slot;
}

}  // namespace

SlotsResponse encode_slots_response(const SlotsRecord& record) {
  SlotsResponse response{kSync0, kSync1, kLayout, record.used};
  std::uint8_t* bytes = &response[kSlotsAt];
  for (const SlotRecord& slot : record.slots) {
    bytes[0] = slot.error;
    store_le32(bytes + kSequenceAt, slot.sequence);
    store_le32(bytes + kModelAt, slot.model);
    store_le32(bytes + kTableAt, slot.table);
    for (std::size_t i = 0; i < slot.serial.size(); ++i) {
      store_le32(bytes + kSerialAt + 4 * i, slot.serial[i]);
    }
    bytes += kSlotBytes;
  }
  store_le32(&response[kCrcAt], crc32(response.data(), kCrcAt));
  return response;
}

bool decode_slots_response(const std::uint8_t* bytes, SlotsRecord& record) {
  if (bytes[0] != kSync0 || bytes[1] != kSync1 || bytes[2] != kLayout) return false;
  if (bytes[kUsedAt] > SlotsRecord::kNone) return false;
  if (load_le32(bytes + kCrcAt) != crc32(bytes, kCrcAt)) return false;
  for (std::size_t end = kSlotsAt + kSlotBytes; end <= kCrcAt; end += kSlotBytes) {
    if (bytes[end - 1] != 0) return false;
  }
  record = {bytes[kUsedAt], {slot_at(bytes + kSlotsAt), slot_at(bytes + kSlotsAt + kSlotBytes)}};
  return true;
}

}  // namespace fog
