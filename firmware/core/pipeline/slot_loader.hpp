#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/frames/load_message.hpp"
#include "core/pipeline/model_slot.hpp"

namespace fog {

/// The board into which a table is to be loaded.
struct LoadTarget {
  std::size_t used = kModelSlots;  ///< slot in use; kModelSlots: none
  std::uint32_t sequence = 0;      ///< of the slot in use
  bool has_owner = false;          ///< a slot in use, or a damaged one, says whose the board is
  std::array<std::uint32_t, kSerialWords> serial{};  ///< of the owner
  std::array<std::uint32_t, kProcessorWords> processor{};

  /// Slot for the next table: never the one in use.
  std::size_t slot() const { return used == 0 ? 1 : 0; }
};

/// First words of a slot, by which a board decides whether to accept the rest: the slot's header
/// and the table's words up to its owner.
constexpr std::size_t kLoadHeadWords = kSlotHeaderWords + kProcessorAt + kProcessorWords;

/// What the chosen slots say of the board.
LoadTarget load_target(const SlotChoice& choice, const std::array<SlotMemory, kModelSlots>& slots,
                       const std::array<std::uint32_t, kProcessorWords>& processor);

/// Reason to refuse a slot that begins with `head`, sent by the tool before anything else. Serial
/// numbers must be the same, an empty one like any other. `options`: kMayBeAnotherGyro,
/// kMayBeFirst.
LoadRefusal refusal_of_head(const std::uint32_t* head, const LoadTarget& target,
                            std::uint32_t options);

/// Whether a slot without its first word would be valid in an image of this `capacity`: seal,
/// table, ranges.
LoadRefusal refusal_of_body(SlotMemory memory, const ModelShape& capacity);

/// Loads a table into the slot that is not in use. The first word, which makes it valid, is written
/// last, after all others have been read back and checked. So whenever the power fails, the slot in
/// use is unchanged and the other is either empty or valid.
///
/// `Flash` has `bool erase(slot)`, `bool program(slot, at, words, count)`, in words, and
/// `SlotMemory memory(slot)`.
template <class Flash>
class SlotLoader {
 public:
  SlotLoader(Flash& flash, const LoadTarget& target, const ModelShape& capacity)
      : flash_(flash), target_(target), capacity_(capacity) {}

  LoadAnswer take(const LoadMessage& message, bool strap_closed) {
    return {message.step, strap_closed ? step(message) : LoadRefusal::strap_open, next_};
  }
  /// Whether a `begin` has been accepted: from then on samples are not answered, even after an
  /// error.
  bool has_begun() const { return has_begun_; }
  bool has_ended() const { return has_ended_; }

 private:
  LoadRefusal step(const LoadMessage& message) {
    switch (message.step) {
      case LoadStep::begin:
        return begin(message);
      case LoadStep::block:
        return block(message);
      case LoadStep::end:
        return end();
    }
    return LoadRefusal::not_expected;
  }

  LoadRefusal begin(const LoadMessage& message) {
    if (has_ended_ || message.size != kLoadHeadWords) return LoadRefusal::not_expected;
    const LoadRefusal refusal = refusal_of_head(message.words.data(), target_, message.at);
    if (refusal != LoadRefusal::none) return refusal;
    has_begun_ = true;
    total_ = static_cast<std::uint32_t>(kSlotHeaderWords) + message.words[3] + 1;
    next_ = 0;
    // Half erased, a slot that still began like one could pass for a newer table of another gyro.
    if (!retire(target_.slot()) || !flash_.erase(target_.slot())) return LoadRefusal::flash_failed;
    next_ = 1;
    return write(message.words.data() + 1, kLoadHeadWords - 1);
  }

  // A block that was written, but whose answer was lost, comes again.
  LoadRefusal block(const LoadMessage& message) {
    if (next_ == 0 || has_ended_ || message.size > total_) return LoadRefusal::not_expected;
    if (message.at < next_ && message.at + message.size == next_) {
      return holds(message.at, message.words.data(), message.size) ? LoadRefusal::none
                                                                   : LoadRefusal::not_expected;
    }
    if (message.at != next_ || message.size > total_ - next_) return LoadRefusal::not_expected;
    return write(message.words.data(), message.size);
  }

  LoadRefusal end() {
    if (has_ended_) return LoadRefusal::none;
    if (next_ == 0 || next_ != total_) return LoadRefusal::not_expected;
    const LoadRefusal refusal = refusal_of_body(flash_.memory(target_.slot()), capacity_);
    if (refusal != LoadRefusal::none) return refusal;
    const auto magic = static_cast<std::uint32_t>(kSlotMagic);
    if (!flash_.program(target_.slot(), 0, &magic, 1) || !holds(0, &magic, 1)) {
      return LoadRefusal::flash_failed;
    }
    has_ended_ = true;
    retire_other_gyro();
    return LoadRefusal::none;
  }

  // The table of another gyro must not be used if the new one is ever damaged, and a damaged one
  // would be in the way of the new one. After a failure here an intact one is merely older.
  void retire_other_gyro() {
    const std::size_t other = target_.slot() ^ 1U;
    const SlotMemory loaded = flash_.memory(target_.slot());
    if (!have_same_serial(loaded, flash_.memory(other))) retire(other);
  }

  bool retire(std::size_t slot) {
    constexpr auto kRetired = static_cast<std::uint32_t>(kRetiredMagic);
    return flash_.program(slot, 0, &kRetired, 1);
  }

  LoadRefusal write(const std::uint32_t* words, std::size_t count) {
    if (!flash_.program(target_.slot(), next_, words, count) || !holds(next_, words, count)) {
      next_ = 0;  // a damaged slot has to be erased
      return LoadRefusal::flash_failed;
    }
    next_ += static_cast<std::uint32_t>(count);
    return LoadRefusal::none;
  }

  bool holds(std::size_t at, const std::uint32_t* words, std::size_t count) const {
    const SlotMemory memory = flash_.memory(target_.slot());
    for (std::size_t i = 0; i < count; ++i) {
      if (static_cast<std::uint32_t>(memory[at + i]) != words[i]) return false;
    }
    return true;
  }

  Flash& flash_;
  LoadTarget target_;
  const ModelShape& capacity_;
  std::uint32_t total_ = 0;  // words of the slot to be loaded
  std::uint32_t next_ = 0;   // words written so far; 0: a `begin` is needed
  bool has_begun_ = false;
  bool has_ended_ = false;
};

}  // namespace fog
