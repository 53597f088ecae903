#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/frames/load_message.hpp"
#include "core/pipeline/model_slot.hpp"

namespace fog {

/// What a board has when a table is to be loaded into it.
struct LoadTarget {
  std::size_t used = kModelSlots;                    ///< slot in use; kModelSlots: none
  std::uint32_t sequence = 0;                        ///< of the slot in use
  std::array<std::uint32_t, kSerialWords> serial{};  ///< of its gyro; all 0: none
  std::array<std::uint32_t, kProcessorWords> processor{};

  /// Where the next table goes: never where the one in use is.
  std::size_t slot() const { return used == 0 ? 1 : 0; }
};

/// The first words of a slot, by which a board judges whether the rest may come: the slot's header,
/// and the table's up to whose it is.
constexpr std::size_t kLoadHeadWords = kSlotHeaderWords + kProcessorAt + kProcessorWords;

/// Why a slot that begins with these words is not for this board, which the tool asks before it
/// sends anything. `options`: kMayBeAnotherGyro.
LoadRefusal refusal_of_head(const std::uint32_t* head, const LoadTarget& target,
                            std::uint32_t options);

/// Whether a slot whose first word is still missing would be a good one in an image with this
/// `room`: seal, table, ranges.
LoadRefusal refusal_of_body(SlotMemory memory, const ModelShape& capacity);

/// Loads a table into the slot that is not in use. Its first word, without which it is none, is
/// written last, when all behind it has been read back and checked. So whenever the power goes, the
/// slot in use is as it was, and the other is either none or good.
///
/// `Flash` has `bool erase(slot)`, `bool program(slot, at, words, count)`, in words, and
/// `SlotMemory memory(slot)`.
template <class Flash>
class SlotLoader {
 public:
  SlotLoader(Flash& flash, const LoadTarget& target, const ModelShape& capacity)
      : flash_(flash), target_(target), room_(capacity) {}

  LoadAnswer take(const LoadMessage& message, bool strap_closed) {
    return {message.step, strap_closed ? step(message) : LoadRefusal::strap_open, next_};
  }
  /// From a begin that was accepted on: samples are not answered, whatever comes of it.
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
    if (!flash_.erase(target_.slot())) return LoadRefusal::flash_failed;
    next_ = 1;
    return write(message.words.data() + 1, kLoadHeadWords - 1);
  }

  // One that was written, and whose answer was lost, comes again.
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
    const LoadRefusal refusal = refusal_of_body(flash_.memory(target_.slot()), room_);
    if (refusal != LoadRefusal::none) return refusal;
    const auto magic = static_cast<std::uint32_t>(kSlotMagic);
    if (!flash_.program(target_.slot(), 0, &magic, 1) || !holds(0, &magic, 1)) {
      return LoadRefusal::flash_failed;
    }
    has_ended_ = true;
    return LoadRefusal::none;
  }

  LoadRefusal write(const std::uint32_t* words, std::size_t count) {
    if (!flash_.program(target_.slot(), next_, words, count) || !holds(next_, words, count)) {
      next_ = 0;  // what is spoilt has to be erased
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
  const ModelShape& room_;
  std::uint32_t total_ = 0;  // words of the slot that is coming
  std::uint32_t next_ = 0;   // of them are there; 0: none, begin first
  bool has_begun_ = false;
  bool has_ended_ = false;
};

}  // namespace fog
