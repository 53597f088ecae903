#pragma once

#include "core/fixed_point/overflow.hpp"

namespace fog::test {

/// How often a test repeats: all of `count` in the optimised build, which counts how often
/// something holds, and `sanitized` (about a tenth) in the sanitized build, which is ten times
/// slower and looks for faults of memory and of arithmetic: the first repetitions find those.
#if defined(FOG_CHECKED_FIXED)
template <class Number>
constexpr Number repeats(Number /*count*/, Number sanitized) {
  return sanitized;
}
#else
template <class Number>
constexpr Number repeats(Number count, Number /*sanitized*/) {
  return count;
}
#endif

}  // namespace fog::test
