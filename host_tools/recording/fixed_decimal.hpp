#pragma once

#include <cstddef>

namespace fogcomp::recording {

constexpr std::size_t kLongestDecimal = 32;

/// Prints `value` rounded to `decimals` places (0 to 10), without trailing zeros, at `out`, which
/// must have kLongestDecimal bytes; returns the end. Values above 2^53 units of the last place are
/// printed in shortest exact form.
char* print_fixed(double value, int decimals, char* out);

}  // namespace fogcomp::recording
