#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

/// ln(raw * 2^-fraction) for raw > 0, clipped at +-32. Error at most 8.98e-9 for raw below 2^32 and
/// 1e-8 above, of which 7.5e-9 is the rounding of the result (bench/core_functions: all of the
/// former, 10^9 draws of the latter).
Fixed<std::int32_t, 26> natural_logarithm(std::int64_t raw, int fraction);

/// ln(x) for x > 0.
template <int kFractionalBits>
Fixed<std::int32_t, 26> natural_logarithm(Fixed<std::int64_t, kFractionalBits> x) {
  return natural_logarithm(x.raw(), kFractionalBits);
}

}  // namespace fog
