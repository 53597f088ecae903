#pragma once

#include <cstddef>
#include <cstdint>

#include "core/health/memory_march.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Words in use that a test overwrites and restores; volatile keeps every access.
struct LiveWords {
  volatile std::uint32_t* words;

  std::uint32_t read(std::size_t i) const { return words[i]; }
  void write(std::size_t i, std::uint32_t value) { words[i] = value; }
};

/// Runs the march test over a memory in use, one block of kBlockWords per step, with another
/// pattern in each pass. `Words`: how the memory is read and written.
template <class Words = LiveWords>
class MemoryScan {
 public:
  static constexpr std::size_t kBlockWords = 4;

  /// Only whole blocks are tested: up to 3 words of `memory` are not.
  explicit MemoryScan(Span<volatile std::uint32_t> memory) : memory_(memory) {}

  /// Tests the next block, unless it overlaps `in_use`, the stack of this call and its callers.
  /// Returns false if a cell failed. Interrupts must be disabled.
  bool step(Span<volatile std::uint32_t> in_use) {
    const Span<volatile std::uint32_t> block{memory_.data + position_, kBlockWords};
    bool good = true;
    if (block.end() <= in_use.begin() || block.begin() >= in_use.end()) {
      Words words{block.data};
      good = march_and_restore<kBlockWords>(words, kMarchPatterns[pattern_]);
    }
    position_ += kBlockWords;
    if (position_ + kBlockWords > memory_.size) {
      position_ = 0;
      pattern_ = pattern_ + 1 < kMarchPatterns.size() ? pattern_ + 1 : 0;
    }
    return good;
  }

  std::size_t blocks() const { return memory_.size / kBlockWords; }

 private:
  Span<volatile std::uint32_t> memory_;
  std::size_t position_ = 0;
  std::size_t pattern_ = 0;
};

}  // namespace fog
