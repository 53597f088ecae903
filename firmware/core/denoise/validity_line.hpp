#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/shift.hpp"

namespace fog {

/// Which of the latest samples, up to kMax, were valid. As long as all were and valid ones follow,
/// nothing needs to be exchanged.
template <std::size_t kMax>
class ValidityLine {
 public:
  bool settled() const { return unsettled_ == 0; }

  /// Not settled until `samples` valid ones have been exchanged.
  void unsettle(std::size_t samples) { unsettled_ = samples; }

  /// Notes whether the newest of `length` samples is valid, and tells whether the oldest was.
  bool exchange(bool valid, std::size_t length) {
    const auto bit = power_of_two<std::uint32_t>(bit_of(next_));
    std::uint32_t& word = invalid_[next_ / 32U];
    if (valid) {
      word &= ~bit;
      --unsettled_;
    } else {
      word |= bit;
      unsettled_ = length;
    }
    if (++next_ == length) next_ = 0;
    return (floor_shift(invalid_[next_ / 32U], bit_of(next_)) & 1U) == 0U;
  }

 private:
  static int bit_of(std::size_t place) { return static_cast<int>(place % 32U); }

  std::array<std::uint32_t, kMax / 32U + 1U> invalid_{};
  std::size_t next_ = 0;       // where the oldest stands; any place, if settled
  std::size_t unsettled_ = 0;  // samples until all since the last fault have been found valid
};

}  // namespace fog
