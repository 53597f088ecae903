#pragma once

#include <cstdint>

namespace fog {

// A single instruction (QSUB) if the processor has it; compilers do not generate it by themselves.

#if defined(__ARM_FEATURE_DSP)
/// a - b, clipped to 32 bits.
inline std::int32_t saturating_difference(std::int32_t a, std::int32_t b) {
  return __builtin_arm_qsub(a, b);
}
#else
inline std::int32_t saturating_difference(std::int32_t a, std::int32_t b) {
  std::int32_t difference = 0;
  if (!__builtin_sub_overflow(a, b, &difference)) return difference;
  return b < 0 ? INT32_MAX : INT32_MIN;
}
#endif

}  // namespace fog
