#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/shift.hpp"

namespace fog {

/// Validity of the latest samples, up to kMax. As long as all of them are valid it does no work.
template <std::size_t kMax>
class ValidityLine {
 public:
  bool settled() const { return unsettled_ == 0; }

  /// The next `samples` exchanges do the full work.
  void unsettle(std::size_t samples) { unsettled_ = samples; }

  /// Stores the validity of the newest of `length` samples and returns that of the oldest.
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
  std::size_t next_ = 0;       // slot of the oldest; arbitrary while settled
  std::size_t unsettled_ = 0;  // samples until all since the last fault are known to be valid
};

}  // namespace fog
