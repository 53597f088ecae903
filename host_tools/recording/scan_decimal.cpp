#include "recording/scan_decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <system_error>

namespace fogcomp {
namespace {

// Powers of ten that doubles hold exactly.
constexpr std::array<double, 23> kExactPowerOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                  1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kLargestExactInteger = std::uint64_t{1} << 53U;
constexpr std::ptrdiff_t kMostDigits = 19;  // any 19 digits fit 64 bits

bool is_digit(char character) {
  return static_cast<unsigned char>(character - '0') < 10;
}

const char* scan_slowly(const char* first, const char* last, bool negative, double& value) {
  double magnitude = 0;
  const auto result = std::from_chars(first, last, magnitude);
  if (result.ec != std::errc() || !std::isfinite(magnitude)) return nullptr;
  value = negative ? -magnitude : magnitude;
  return result.ptr;
}

}  // namespace

// Clinger's fast path: digits that fit a double as an integer, divided by a power of ten that is
// exact too, round once. Everything longer, and exponents, go the slow way.
const char* scan_decimal(const char* first, const char* last, double& value) {
  const bool negative = *first == '-';
  if (negative || *first == '+') ++first;
  if (!is_digit(*first) && *first != '.') return nullptr;  // also keeps "inf", "nan" and "--1" out

  const char* p = first;
  std::uint64_t digits = 0;
  while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
  std::ptrdiff_t length = p - first;
  std::ptrdiff_t decimals = 0;
  if (*p == '.') {
    const char* point = p++;
    while (is_digit(*p)) digits = 10 * digits + static_cast<std::uint64_t>(*p++ - '0');
    decimals = p - point - 1;
    length += decimals;
  }
  if (length == 0) return nullptr;
  if (length > kMostDigits || digits > kLargestExactInteger || *p == 'e' || *p == 'E') {
    return scan_slowly(first, last, negative, value);
  }
  const double magnitude =
      static_cast<double>(digits) / kExactPowerOfTen[static_cast<std::size_t>(decimals)];
  value = negative ? -magnitude : magnitude;
  return p;
}

}  // namespace fogcomp
