#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// Contents of a model slot.
struct SlotRecord {
  std::uint8_t error = 0;                 ///< a ModelError: why it cannot be used; none: it can
  std::uint32_t sequence = 0;             ///< of two the newer has the higher
  std::uint32_t model = 0;                ///< CRC-32 of the model file
  std::uint32_t table = 0;                ///< CRC-32 of the table
  std::array<std::uint32_t, 4> serial{};  ///< of the gyro, ASCII, padded with 0
};

/// Contents of both slots, as the board reports them (SPEC.md, "Slots record").
struct SlotsRecord {
  static constexpr std::uint8_t kNone = 2;
  std::uint8_t used = kNone;  ///< 0, 1
  std::array<SlotRecord, 2> slots{};
};

constexpr std::size_t kSlotsResponseBytes = 72;
using SlotsResponse = std::array<std::uint8_t, kSlotsResponseBytes>;

SlotsResponse encode_slots_response(const SlotsRecord& record);

/// Reads kSlotsResponseBytes bytes. Returns false, and changes nothing, unless sync, layout and CRC
/// are right, `used` is a possible value and the serial numbers are terminated.
bool decode_slots_response(const std::uint8_t* bytes, SlotsRecord& record);

}  // namespace fog
