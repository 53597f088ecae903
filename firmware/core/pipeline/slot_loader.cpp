#include "core/pipeline/slot_loader.hpp"

namespace fog {
namespace {

LoadRefusal refusal_of(ModelError error) {
  return error == ModelError::frames_too_long ? LoadRefusal::frames_too_long
                                              : static_cast<LoadRefusal>(error);
}
static_assert(static_cast<int>(LoadRefusal::other_gyro) ==
              static_cast<int>(ModelError::other_gyro));

// A table without a serial number fits any gyro.
bool is_of_another(const std::uint32_t* serial, const LoadTarget& target) {
  bool any = false;
  bool any_here = false;
  bool differs = false;
  for (std::size_t i = 0; i < kSerialWords; ++i) {
    any = any || serial[i] != 0;
    any_here = any_here || target.serial[i] != 0;
    differs = differs || serial[i] != target.serial[i];
  }
  return any && any_here && differs;
}

}  // namespace

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
  if (target.used == kModelSlots) return LoadRefusal::none;
  if ((options & kMayBeAnotherGyro) == 0 && is_of_another(table + kIdentityAt, target)) {
    return LoadRefusal::other_gyro;
  }
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
