#pragma once

#include <cstddef>

namespace fogcomp::recording {

/// Reads the decimal number that starts at `first` ("-12.5", "+3", ".5", "1e-3") into `value`,
/// rounded to the nearest double, and returns its end; nullptr if none starts there or it
/// overflows. `last` must be readable and be neither a digit nor a point. "inf" and "nan" are not
/// numbers.
const char* scan_decimal(const char* first, const char* last, double& value);

constexpr std::size_t kLongestDecimal = 32;

/// Prints `value` rounded to `decimals` places (0 to 10), without trailing zeros, at `out`, which
/// must have kLongestDecimal bytes; returns the end. Values above 2^53 units of the last place are
/// printed in shortest exact form.
char* print_fixed(double value, int decimals, char* out);

}  // namespace fogcomp::recording
