#pragma once

namespace fogcomp::recording {

/// Reads the decimal number that starts at `first` ("-12.5", "+3", ".5", "1e-3") into `value`,
/// rounded to the nearest double, and returns its end; nullptr if none starts there or it
/// overflows. `last` must be readable and be neither a digit nor a point. "inf" and "nan" are not
/// numbers.
const char* scan_decimal(const char* first, const char* last, double& value);

}  // namespace fogcomp::recording
