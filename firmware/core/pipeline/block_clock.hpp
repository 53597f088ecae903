#pragma once

#include <cstdint>

namespace fog {

/// Divides the sample count into blocks.
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
    return position / samples_per_block_;
  }

 private:
  std::uint32_t samples_per_block_;
  std::uint32_t position_ = 0;
};

}  // namespace fog
