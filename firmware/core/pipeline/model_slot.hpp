#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/pipeline/model_parameters.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// A model table that is loaded lies in one of two slots of flash (SPEC.md, "Model slots"):
///   "FOGS" | slot layout | sequence | words of the table | the table | seal
/// each an int32, little-endian. With the seal the CRC-32 over all of it, begun with kIntactImage,
/// comes to kIntactImage, so that the self-test goes on from the image through it.
constexpr std::int32_t kSlotMagic = 0x53474F46;
constexpr std::int32_t kSlotLayout = 1;
constexpr std::size_t kSlotHeaderWords = 4;
constexpr std::size_t kSlotBytes = 16384;  ///< a sector of the smallest flash that has two
constexpr std::size_t kMaxSlotWords = kSlotBytes / sizeof(std::int32_t) - kSlotHeaderWords - 1;
constexpr std::size_t kModelSlots = 2;

/// What the generic image, into which a model is loaded, has room for: everything but a denoiser
/// of other filters or more levels.
constexpr std::size_t kGenericTaps = kOrNone + 16;  ///< sym8, db8
constexpr std::size_t kGenericLevels = 6;           ///< 3.8 KiB of RAM; each more doubles it
constexpr ModelShape kGenericImage{kAllEffects, kAllExpressions, kAllNetworkInputs,
                                   filters_of(kGenericTaps), kGenericLevels};

using SlotMemory = Span<const std::int32_t>;  ///< kSlotBytes

struct SlotContents {
  ModelError error = ModelError::not_a_model;  ///< of the slot alone; none: it is intact
  std::uint32_t sequence = 0;                  ///< the higher, the newer; wraps
  Span<const std::int32_t> table;              ///< where it is intact
  Span<const std::uint8_t> sealed;             ///< all of it, with its seal
};
SlotContents read_slot(SlotMemory memory);
/// The same of one whose first word is to be written yet; of at least kSlotHeaderWords words.
SlotContents read_slot_behind_magic(SlotMemory memory);

/// What a board makes of its slots.
struct SlotChoice {
  ModelError error = ModelError::not_a_model;  ///< none: `slot` is used; else why the newest is not
  std::size_t slot = kModelSlots;
  /// What lies in each; its error is of the model too, as far as that was looked at.
  std::array<SlotContents, kModelSlots> slots;

  const SlotContents& used() const { return slots[slot % kModelSlots]; }  ///< where one is
};

/// The newest intact slot whose model an image with this `room` on this processor can have; it is
/// taken apart into `parameters`, which without one are those of a refused model.
SlotChoice choose_slot(const std::array<SlotMemory, kModelSlots>& slots, const ModelShape& capacity,
                       const std::array<std::uint32_t, kProcessorWords>& processor,
                       ModelParameters& parameters);

}  // namespace fog
