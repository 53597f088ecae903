#pragma once

#include "core/fixed_point/overflow.hpp"

namespace fog::test {

/// Number of repetitions of a test: `count` in the optimised build, which counts how often a
/// property holds; `sanitized` (about a tenth) in the sanitized build, which is ten times slower
/// and finds errors of memory and arithmetic in the first repetitions.
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
