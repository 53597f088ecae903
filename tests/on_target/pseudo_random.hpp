#pragma once

#include <cstdint>

namespace fog::checks {

/// The same numbers on every processor (Marsaglia's xorshift, period 2^32 - 1).
class PseudoRandom {
 public:
  std::uint32_t next() {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 17U;
    state_ ^= state_ << 5U;
    return state_;
  }
  std::int32_t next_signed() { return static_cast<std::int32_t>(next()); }

 private:
  std::uint32_t state_ = 2463534242U;
};

}  // namespace fog::checks
