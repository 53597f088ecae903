#pragma once

#include <cstdint>

#include "core/bytes/state_carrier.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Divides the samples into blocks and counts the blocks since power-on.
class BlockClock {
 public:
  /// samples_per_block from 1 to 2^31 - 1.
  explicit BlockClock(std::uint32_t samples_per_block) : samples_per_block_(samples_per_block) {}

  /// Advances by `samples` (below 2^31); returns how many blocks they completed.
  std::uint32_t advance(std::uint32_t samples) {
    static_assert(std::uint64_t{INT32_MAX - 1} + INT32_MAX <= UINT32_MAX);  // the position
    const std::uint32_t position = now_.position + samples;
    if (position < samples_per_block_) {
      now_.position = position;
      return 0;
    }
    now_.position = position % samples_per_block_;
    const std::uint32_t blocks = position / samples_per_block_;
    constexpr auto kMax = static_cast<std::uint32_t>(Elapsed::highest().raw());
    now_.elapsed = blocks < kMax - now_.elapsed ? now_.elapsed + blocks : kMax;
    return blocks;
  }

  void carry(StateCarrier& state) { state(now_); }

  /// Blocks completed so far; saturates after 68 years.
  Elapsed elapsed() const { return Elapsed::from_raw(static_cast<std::int32_t>(now_.elapsed)); }

 private:
  std::uint32_t samples_per_block_;
  struct {
    std::uint32_t position = 0;  // samples of the current block
    std::uint32_t elapsed = 0;   // blocks
  } now_;
};

}  // namespace fog
