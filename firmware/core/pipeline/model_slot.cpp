#include "core/pipeline/model_slot.hpp"

#include "core/bytes/crc.hpp"
#include "core/health/image_seal.hpp"

namespace fog {
namespace {

// The sequence of a slot that is not intact may be what is damaged: it counts as the newer one, so
// that the other has to be of the same gyro.
bool is_newer(const SlotContents& a, const SlotContents& b) {
  if (a.is_slot != b.is_slot) return a.is_slot;
  const bool damaged = a.error != ModelError::none;
  if (damaged != (b.error != ModelError::none)) return damaged;
  return static_cast<std::int32_t>(a.sequence - b.sequence) >= 0;
}

ModelError read_for(const SlotContents& slot, const ModelShape& capacity,
                    const std::array<std::uint32_t, kProcessorWords>& processor,
                    ModelParameters& parameters) {
  const ModelError error = read_model(slot.table, capacity, parameters);
  if (error != ModelError::none) return error;
  if (!is_bound_elsewhere(slot.table.data + kProcessorAt, processor)) return ModelError::none;
  read_model({}, capacity,
             parameters);  // resets it in place: a second object would take a fifth of the stack
  return ModelError::other_board;
}

}  // namespace

Span<const std::uint8_t> slot_magic() {
  return {reinterpret_cast<const std::uint8_t*>(&kSlotMagic), sizeof kSlotMagic};
}

SlotContents read_slot(SlotMemory memory) {
  constexpr std::int32_t kErased = -1;
  if (memory.size < kSlotHeaderWords) return {};
  if (memory[0] == kErased || memory[0] == kRetiredMagic) return {};
  SlotContents slot = read_slot_behind_magic(memory);
  slot.is_slot = memory[0] == kSlotMagic || slot.error == ModelError::none;
  if (!slot.is_slot) slot.error = ModelError::damaged;
  return slot;
}

SlotContents read_slot_behind_magic(SlotMemory memory) {
  SlotContents slot;
  slot.sequence = static_cast<std::uint32_t>(memory[2]);
  slot.error = ModelError::other_layout;
  if (memory[1] != kSlotLayout) return slot;
  slot.error = ModelError::damaged;
  const auto words = static_cast<std::uint32_t>(memory[3]);
  if (words > kMaxSlotWords || kSlotHeaderWords + words + 1 > memory.size) return slot;
  const Span<const std::uint8_t> sealed{reinterpret_cast<const std::uint8_t*>(memory.data + 1),
                                        (kSlotHeaderWords + words) * sizeof(std::int32_t)};
  const Span<const std::uint8_t> magic = slot_magic();
  const std::uint32_t magic_crc = crc32(magic.data, magic.size, kIntactImage);
  if (crc32(sealed.data, sealed.size, magic_crc) != kIntactImage) return slot;
  slot.error = ModelError::none;
  slot.table = {memory.data + kSlotHeaderWords, words};
  slot.sealed = sealed;
  return slot;
}

bool have_same_serial(SlotMemory a, SlotMemory b) {
  constexpr std::uint8_t kErased = 0xFF;  // in no serial number
  constexpr std::size_t kSerialAt = kSlotHeaderWords + kIdentityAt;
  const auto* const one = reinterpret_cast<const std::uint8_t*>(a.data + kSerialAt);
  const auto* const other = reinterpret_cast<const std::uint8_t*>(b.data + kSerialAt);
  for (std::size_t i = 0; i < kSerialWords * sizeof(std::int32_t); ++i) {
    if (one[i] != other[i] && one[i] != kErased && other[i] != kErased) return false;
  }
  return true;
}

SlotChoice choose_slot(const std::array<SlotMemory, kModelSlots>& slots, const ModelShape& capacity,
                       const std::array<std::uint32_t, kProcessorWords>& processor,
                       ModelParameters& parameters) {
  SlotChoice choice;
  choice.slots = {read_slot(slots[0]), read_slot(slots[1])};
  choice.newest = is_newer(choice.slots[0], choice.slots[1]) ? 0 : 1;
  const auto use = [&](std::size_t slot) {
    ModelError& error = choice.slots[slot].error;
    if (error == ModelError::none) {
      error = read_for(choice.slots[slot], capacity, processor, parameters);
    }
    if (error == ModelError::none) choice.slot = slot;
    return error;
  };
  choice.error = use(choice.newest);
  if (choice.error == ModelError::none) return choice;
  SlotContents& older = choice.slots[choice.newest ^ 1U];
  if (older.error == ModelError::none && !have_same_serial(slots[0], slots[1])) {
    older.error = ModelError::other_gyro;
  }
  if (use(choice.newest ^ 1U) == ModelError::none) choice.error = ModelError::none;
  return choice;
}

}  // namespace fog
