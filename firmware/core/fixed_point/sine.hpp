#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

struct SineCosine {
  Fixed<std::int32_t, 30> sine;
  Fixed<std::int32_t, 30> cosine;
};

/// Sine and cosine of phase * 2^-32 turns. Error of each at most 4.32e-9 (bench/core_functions:
/// all phases).
SineCosine sine_cosine(std::uint32_t phase);

/// The same for an angle in turns; whole turns are dropped, the rest is rounded to 2^-32.
template <int kFractionalBits>
SineCosine sine_cosine_of_turns(Fixed<std::int64_t, kFractionalBits> turns) {
  static_assert(kFractionalBits >= 32);
  return sine_cosine(static_cast<std::uint32_t>(round_shift(turns.raw(), kFractionalBits - 32)));
}

}  // namespace fog
