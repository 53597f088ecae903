#pragma once

#include <cstdint>

namespace fog {

/// sum + a.low * b.low + a.high * b.high, where low and high are the halves of a word, signed; the
/// caller keeps the sum within 32 bits. One instruction (SMLAD) where the processor has it, which
/// no compiler finds by itself.
#if defined(__ARM_FEATURE_SIMD32)
inline std::int32_t add_dual_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  return __builtin_arm_smlad(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), sum);
}
#else
inline std::int32_t add_dual_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  const auto low = [](std::uint32_t word) { return static_cast<std::int16_t>(word); };
  return sum + low(a) * low(b) + low(a >> 16U) * low(b >> 16U);
}
#endif

}  // namespace fog
