#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// Divides the sample count into blocks, and counts the blocks since power-on.
class BlockClock {
 public:
  /// samples_per_block from 1 to 2^31 - 1.
  explicit BlockClock(std::uint32_t samples_per_block) : samples_per_block_(samples_per_block) {}

  /// Lets `samples` (below 2^31) pass; returns how many blocks they completed.
  std::uint32_t advance(std::uint32_t samples) {
    const std::uint32_t position = position_ + samples;
    if (position < samples_per_block_) {
      position_ = position;
      return 0;
    }
    position_ = position % samples_per_block_;
    const std::uint32_t blocks = position / samples_per_block_;
    constexpr auto kMost = static_cast<std::uint32_t>(Elapsed::highest().raw());
    elapsed_ = blocks < kMost - elapsed_ ? elapsed_ + blocks : kMost;
    return blocks;
  }

  /// Blocks completed so far; stays at its highest value after 68 years.
  Elapsed elapsed() const { return Elapsed::from_raw(static_cast<std::int32_t>(elapsed_)); }

 private:
  std::uint32_t samples_per_block_;
  std::uint32_t position_ = 0;
  std::uint32_t elapsed_ = 0;
};

}  // namespace fog
