#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/pipeline/model_parameters.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// A loaded model table is stored in one of two slots of flash (SPEC.md, "Model slots"):
///   "FOGS" | slot layout | sequence | words of the table | the table | seal
/// each field an int32, little-endian. With the seal the CRC-32 over the whole slot, started with
/// kIntactImage, is kIntactImage, so that the self-test continues from the image through the slot.
constexpr std::int32_t kSlotMagic = 0x53474F46;
constexpr std::int32_t kRetiredMagic = 0;  ///< makes a slot none; can be written over any
constexpr std::int32_t kSlotLayout = 1;
constexpr std::size_t kSlotHeaderWords = 4;
constexpr std::size_t kSlotBytes = 16384;  ///< a sector of the smallest flash that has two
constexpr std::size_t kMaxSlotWords = kSlotBytes / sizeof(std::int32_t) - kSlotHeaderWords - 1;
constexpr std::size_t kModelSlots = 2;

/// Capacity of the generic image, into which a model is loaded: everything but denoisers with other
/// filters or more levels.
constexpr std::size_t kGenericTaps = kOrNone + 16;  ///< sym8, db8
constexpr std::size_t kGenericLevels = 6;           ///< 3.8 KiB of RAM; each more doubles it
constexpr ModelShape kGenericImage{kAnyEffects, kAllExpressions, kAllNetworkInputs,
                                   filters_of(kGenericTaps), kGenericLevels};

using SlotMemory = Span<const std::int32_t>;  ///< kSlotBytes

struct SlotContents {
  ModelError error = ModelError::not_a_model;  ///< of the slot alone; none: it is intact
  /// It has the magic word, or is intact behind another, of which a bit has flipped or is not yet
  /// written. Else it is erased, retired (not_a_model) or half erased (damaged).
  bool is_slot = false;
  std::uint32_t sequence = 0;       ///< the higher, the newer; wraps
  Span<const std::int32_t> table;   ///< empty unless intact
  Span<const std::uint8_t> sealed;  ///< all behind the magic word, with the seal
};
/// The magic word, as the seal has it: the slot's own first word only says that it is one.
Span<const std::uint8_t> slot_magic();
SlotContents read_slot(SlotMemory memory);
/// The same whatever the first word is, which may not be written yet; at least kSlotHeaderWords
/// words.
SlotContents read_slot_behind_magic(SlotMemory memory);

/// Whether the serial numbers in two slots are the same, as they stand there; of kSlotBytes each. A
/// byte that was not written says nothing: a load may have been cut off.
bool have_same_serial(SlotMemory a, SlotMemory b);

/// Result of the choice between the slots.
struct SlotChoice {
  ModelError error =
      ModelError::not_a_model;  ///< none: `slot` is used; else the error of the newest
  std::size_t slot = kModelSlots;
  std::size_t newest = 0;  ///< a damaged slot; else the one with the higher sequence
  /// Contents of each slot, with the error of its model, if that was checked.
  std::array<SlotContents, kModelSlots> slots;

  const SlotContents& used() const { return slots[slot % kModelSlots]; }  ///< if one is used
};

/// Chooses the newest intact slot whose model an image of this `capacity` on this processor can
/// run, and decodes it into `parameters`. Where that cannot be used, or a slot is damaged, which
/// may have been the newest, another one only counts if it is of the same gyro. Without a table
/// these are the parameters of a refused model.
SlotChoice choose_slot(const std::array<SlotMemory, kModelSlots>& slots, const ModelShape& capacity,
                       const std::array<std::uint32_t, kProcessorWords>& processor,
                       ModelParameters& parameters);

}  // namespace fog
