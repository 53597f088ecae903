#pragma once

#include <cstdint>

namespace fog {

/// What a checked build (-DFOG_CHECKED_FIXED) does on fixed-point overflow: it counts, and records
/// the place of the first one. Overflow is a programming error: every bound in core is derived next
/// to the arithmetic, and the tests run in this build to confirm it. The flash image checks nothing
/// and wraps (on unsigned integers), so even then host and board agree.
#if defined(FOG_CHECKED_FIXED)
struct OverflowLog {
  std::uint32_t count = 0;
  const void* first_place = nullptr;  ///< return address: addr2line -e TEST_PROGRAM -fi ADDRESS
};

inline OverflowLog& overflow_log() {
  static OverflowLog log;
  return log;
}

[[gnu::noinline]] inline void report_overflow() {
  OverflowLog& log = overflow_log();
  if (log.count++ == 0) log.first_place = __builtin_return_address(0);
}

constexpr void check_range(bool fits) {
  if (!fits) report_overflow();
}
#else
constexpr void check_range(bool) {}
#endif

}  // namespace fog
