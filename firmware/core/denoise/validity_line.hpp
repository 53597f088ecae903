#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/shift.hpp"

namespace fog {

/// Validities on their way through a delay of up to kMax; at first all of them true.
template <std::size_t kMax>
class ValidityLine {
 public:
  /// Stores a validity and returns the one stored `delay` calls before, 0 < delay <= kMax.
  bool exchange(bool valid, std::size_t delay) {
    std::uint32_t& word = invalid_[next_ / 32U];
    const auto place = static_cast<int>(next_ % 32U);
    const std::uint32_t before = word;
    const auto bit = power_of_two<std::uint32_t>(place);
    word = (before | bit) - shift_left(static_cast<std::uint32_t>(valid), place);  // no branch
    if (++next_ == delay) next_ = 0;
    return (floor_shift(before, place) & 1U) == 0U;
  }

 private:
  std::array<std::uint32_t, kMax / 32U + 1U> invalid_{};
  std::size_t next_ = 0;  // slot of the oldest
};

}  // namespace fog
