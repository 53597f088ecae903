#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// Gives back the bit that was put in set_length() calls ago; true before that.
template <std::size_t kMostBits>
class BitDelayLine {
 public:
  /// Before the first exchange; at most kMostBits.
  void set_length(std::size_t length) {
    length_ = length;
    words_.fill(~std::uint32_t{0});
  }

  bool exchange(bool bit) {
    if (length_ == 0) return bit;
    std::uint32_t& word = words_[next_ / 32U];
    const std::uint32_t mask = std::uint32_t{1} << (next_ % 32U);
    const bool oldest = (word & mask) != 0U;
    word = bit ? word | mask : word & ~mask;
    next_ = next_ + 1 == length_ ? 0 : next_ + 1;
    return oldest;
  }

 private:
  std::array<std::uint32_t, kMostBits / 32U + 1U> words_{};
  std::size_t length_ = 0;
  std::size_t next_ = 0;
};

}  // namespace fog
