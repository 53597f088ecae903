#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "core/pipeline/model_slot.hpp"

namespace fog::test {

/// Two slots of flash with realistic behaviour: only erasing sets bits; a write interrupted by a
/// power failure has cleared some of its bits, an interrupted erase has set some, of some words.
class CutFlash {
 public:
  using Memory = std::vector<std::int32_t>;

  CutFlash() : slots_{Memory(kWords, -1), Memory(kWords, -1)} {}

  /// Called before every byte written and around every erase, with the flash as a power failure
  /// would leave it. May throw, to simulate that failure.
  std::function<void()> may_be_cut;
  bool fails = false;      ///< and the flash reports it
  bool is_deaf = false;    ///< ignores writes without reporting it
  std::size_t writes = 0;  ///< bytes and erases
  /// Called before each call of erase() and program(): may let the flash fail from there on.
  std::function<void()> before_call;
  std::size_t erases = 0;

  bool erase(std::size_t slot) {
    if (before_call) before_call();
    if (fails) return false;
    cut();
    // The cells of a sector do not all erase at the same pace: the first words may be last.
    for (const std::size_t untouched : {std::size_t{0}, std::size_t{1}, kWords / 2}) {
      if (!may_be_cut) break;
      const Memory before = slots_[slot];
      for (std::size_t i = untouched; i < kWords; ++i) {
        slots_[slot][i] |= static_cast<std::int32_t>(random_());
      }
      cut();
      slots_[slot] = before;
    }
    ++erases;
    if (!is_deaf) slots_[slot].assign(kWords, -1);
    cut();
    return true;
  }
  bool program(std::size_t slot, std::size_t at, const std::uint32_t* words, std::size_t count) {
    if (before_call) before_call();
    for (std::size_t i = 0; i < count && !fails; ++i) {
      for (unsigned shift = 0; shift < 32; shift += 8) {
        write_byte(slots_[slot].at(at + i), words[i] | ~(0xFFU << shift));
      }
    }
    return !fails;
  }
  SlotMemory memory(std::size_t slot) const { return {slots_[slot].data(), slots_[slot].size()}; }
  Memory& slot(std::size_t number) { return slots_[number]; }
  std::array<SlotMemory, kModelSlots> both() const { return {memory(0), memory(1)}; }

 private:
  static constexpr std::size_t kWords = kSlotBytes / sizeof(std::int32_t);

  void cut() {
    ++writes;
    if (may_be_cut) may_be_cut();
  }
  void write_byte(std::int32_t& word, std::uint32_t mask) {
    if (is_deaf) return;
    const std::int32_t before = word;
    word &= static_cast<std::int32_t>(mask | static_cast<std::uint32_t>(random_()));
    cut();
    word = before & static_cast<std::int32_t>(mask);
  }

  std::array<Memory, kModelSlots> slots_;
  std::mt19937 random_{1};
};

}  // namespace fog::test
