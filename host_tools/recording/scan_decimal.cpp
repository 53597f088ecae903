#include "recording/scan_decimal.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace fogcomp::recording {

const char* scan_decimal(const char* first, const char* last, double& value) {
  const bool negative = *first == '-';
  if (negative || *first == '+') ++first;
  // A second sign, "inf" and "nan" would be numbers to from_chars.
  if (*first != '.' && (*first < '0' || *first > '9')) return nullptr;
  double magnitude = 0;
  const auto result = std::from_chars(first, last, magnitude);
  if (result.ec != std::errc() || !std::isfinite(magnitude)) return nullptr;
  value = negative ? -magnitude : magnitude;
  return result.ptr;
}

}  // namespace fogcomp::recording
