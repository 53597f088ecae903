#pragma once

#include <cstdint>

namespace fog {

// Products of the signed halves of two words; the caller keeps the sum within 32 bits. A single
// instruction (SMLAD, SMLSDX) if the processor has it; compilers do not generate it by themselves.

#if defined(__ARM_FEATURE_SIMD32)
/// sum + a.low * b.low + a.high * b.high
inline std::int32_t add_dual_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  return __builtin_arm_smlad(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), sum);
}
/// sum + a.low * b.high - a.high * b.low
inline std::int32_t add_crossed_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  return __builtin_arm_smlsdx(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), sum);
}
#else
namespace detail {
constexpr std::int32_t low(std::uint32_t word) {
  return static_cast<std::int16_t>(word);
}
constexpr std::int32_t high(std::uint32_t word) {
  return static_cast<std::int16_t>(word >> 16U);
}
}  // namespace detail

inline std::int32_t add_dual_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  return sum + detail::low(a) * detail::low(b) + detail::high(a) * detail::high(b);
}
inline std::int32_t add_crossed_product(std::uint32_t a, std::uint32_t b, std::int32_t sum) {
  return sum + detail::low(a) * detail::high(b) - detail::high(a) * detail::low(b);
}
#endif

}  // namespace fog
