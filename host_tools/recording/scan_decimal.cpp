#include "recording/scan_decimal.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace fogcomp::recording {

const char* scan_decimal(const char* first, const char* last, double& value) {
  const bool negative = *first == '-';
  if (negative || *first == '+') ++first;
  // from_chars would accept a second sign, "inf" and "nan".
  if (*first != '.' && (*first < '0' || *first > '9')) return nullptr;
  double magnitude = 0;
  const auto result = std::from_chars(first, last, magnitude);
  if (result.ec != std::errc() || !std::isfinite(magnitude)) return nullptr;
  value = negative ? -magnitude : magnitude;
  return result.ptr;
}

}  // namespace fogcomp::recording
