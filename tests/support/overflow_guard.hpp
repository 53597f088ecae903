#pragma once

#include <cstdint>

#include "core/fixed_point/overflow.hpp"

namespace fog::test {

#if defined(FOG_CHECKED_FIXED)
constexpr bool kChecked = true;
inline std::uint32_t overflows() {
  return overflow_log().count;
}
inline void forget_overflows() {
  overflow_log() = OverflowLog();
}
#else
// Without checks nothing is counted; the sanitized build runs the same tests with them.
constexpr bool kChecked = false;
inline std::uint32_t overflows() {
  return 0;
}
inline void forget_overflows() {}
#endif

}  // namespace fog::test
