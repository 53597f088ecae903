#pragma once

#include <cstddef>

namespace fogcomp::recording {

constexpr std::size_t kLongestDecimal = 32;

/// Prints `value` rounded to `decimals` places (0 to 10), without trailing zeros, at `out`, which
/// has kLongestDecimal bytes of room; returns the end. Values from 2^53 units of the last place on
/// are printed in shortest exact form.
char* print_fixed(double value, int decimals, char* out);

}  // namespace fogcomp::recording
