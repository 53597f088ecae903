#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fog {

/// Which of the latest samples, up to kMost, were valid. As long as all were and valid ones follow,
/// nothing needs to be exchanged.
template <std::size_t kMost>
class ValidityLine {
 public:
  bool settled() const { return unsettled_ == 0; }

  /// Not settled until `samples` valid ones have been exchanged.
  void unsettle(std::size_t samples) { unsettled_ = samples; }

  /// Notes whether the newest of `length` samples is valid, and tells whether the oldest was.
  bool exchange(bool valid, std::size_t length) {
    const std::uint32_t bit = std::uint32_t{1} << (next_ % 32U);
    std::uint32_t& word = invalid_[next_ / 32U];
    if (valid) {
      word &= ~bit;
      --unsettled_;
    } else {
      word |= bit;
      unsettled_ = length;
    }
    if (++next_ == length) next_ = 0;
    return ((invalid_[next_ / 32U] >> (next_ % 32U)) & 1U) == 0U;
  }

 private:
  std::array<std::uint32_t, kMost / 32U + 1U> invalid_{};
  std::size_t next_ = 0;       // where the oldest stands; any place, if settled
  std::size_t unsettled_ = 0;  // samples until all since the last fault have been found valid
};

}  // namespace fog
