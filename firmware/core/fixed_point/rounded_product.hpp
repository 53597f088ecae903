#pragma once

#include <cstdint>

namespace fog {

/// round_shift(a * b, bits) of the exact product; 0 <= bits <= 62. Not inline: a 64-bit shift by a
/// variable is 80 bytes of code.
std::int64_t rounded_product(std::int32_t a, std::int32_t b, int bits);

}  // namespace fog
