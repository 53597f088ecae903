#pragma once

#include <cstdint>

namespace fog {

/// round_shift(a * b, bits), the product exact; 0 <= bits <= 62. Out of line: 64 bits shifted by a
/// number that only the model table knows are 80 bytes of code.
std::int64_t rounded_product(std::int32_t a, std::int32_t b, int bits);

}  // namespace fog
