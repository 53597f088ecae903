#include "core/pipeline/slot_loader.hpp"

namespace fog {
namespace {

LoadRefusal refusal_of(ModelError error) {
  if (error == ModelError::frames_too_long) return LoadRefusal::frames_too_long;
  if (error == ModelError::sample_too_dear) return LoadRefusal::sample_too_dear;
  return static_cast<LoadRefusal>(error);
}
static_assert(static_cast<int>(LoadRefusal::other_gyro) ==
              static_cast<int>(ModelError::other_gyro));

// A board belongs to the gyro of its table. Also a table without a serial number is one: it would
// open the way to any other.
LoadRefusal refusal_of_owner(const std::uint32_t* serial, const LoadTarget& target,
                             std::uint32_t options) {
  if ((options & kMayBeAnotherGyro) != 0) return LoadRefusal::none;
  if (!target.has_owner) {
    return (options & kMayBeFirst) != 0 ? LoadRefusal::none : LoadRefusal::no_owner;
  }
  for (std::size_t i = 0; i < kSerialWords; ++i) {
    if (serial[i] != target.serial[i]) return LoadRefusal::other_gyro;
  }
  return LoadRefusal::none;
}

}  // namespace

LoadTarget load_target(const SlotChoice& choice, const std::array<SlotMemory, kModelSlots>& slots,
                       const std::array<std::uint32_t, kProcessorWords>& processor) {
  LoadTarget target;
  target.processor = processor;
  const std::size_t owner = choice.slot != kModelSlots ? choice.slot : choice.newest;
  if (choice.slot != kModelSlots) {
    target.used = choice.slot;
    target.sequence = choice.used().sequence;
  }
  target.has_owner = choice.slots[owner].is_slot;
  if (target.has_owner) {
    for (std::size_t i = 0; i < kSerialWords; ++i) {
      target.serial[i] =
          static_cast<std::uint32_t>(slots[owner][kSlotHeaderWords + kIdentityAt + i]);
    }
  }
  return target;
}

LoadRefusal refusal_of_head(const std::uint32_t* head, const LoadTarget& target,
                            std::uint32_t options) {
  const std::uint32_t* const table = head + kSlotHeaderWords;
  if (head[0] != static_cast<std::uint32_t>(kSlotMagic) ||
      table[0] != static_cast<std::uint32_t>(kModelMagic)) {
    return LoadRefusal::not_a_model;
  }
  if (head[1] != static_cast<std::uint32_t>(kSlotLayout) ||
      table[1] != static_cast<std::uint32_t>(kModelLayout)) {
    return LoadRefusal::other_layout;
  }
  if (head[3] > kMaxSlotWords) return LoadRefusal::not_in_image;
  if (table[2] != head[3] || head[3] <= kProcessorAt + kProcessorWords) return LoadRefusal::damaged;
  std::array<std::int32_t, kProcessorWords> bound{};
  for (std::size_t i = 0; i < bound.size(); ++i) {
    bound[i] = static_cast<std::int32_t>(table[kProcessorAt + i]);
  }
  if (is_bound_elsewhere(bound.data(), target.processor)) return LoadRefusal::other_board;
  const LoadRefusal refusal = refusal_of_owner(table + kIdentityAt, target, options);
  if (refusal != LoadRefusal::none || target.used == kModelSlots) return refusal;
  const bool is_newer = static_cast<std::int32_t>(head[2] - target.sequence) > 0;
  return is_newer ? LoadRefusal::none : LoadRefusal::not_newer;
}

LoadRefusal refusal_of_body(SlotMemory memory, const ModelShape& capacity) {
  const SlotContents slot = read_slot_behind_magic(memory);
  if (slot.error != ModelError::none) return refusal_of(slot.error);
  ModelParameters parameters;
  return refusal_of(read_model(slot.table, capacity, parameters));
}

}  // namespace fog
