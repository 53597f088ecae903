#include "recording/csv_fields.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>

namespace fogcomp::recording {
namespace {

// Powers of ten that a double holds exactly.
constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kMaxDecimals = 22;

// Of a number as nearly all are, digits and decimals that are exact, as is their quotient but for
// one rounding (Clinger 1990). nullptr for any other.
const char* scan_short(const char* first, double& value) {
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53U;
  std::uint64_t number = 0;
  int digits = 0;
  int decimals = 0;
  const auto take_digits = [&](int& count) {
    for (; *first >= '0' && *first <= '9' && number < kExact; ++first, ++count) {
      number = 10 * number + static_cast<std::uint64_t>(*first - '0');
    }
  };
  take_digits(digits);
  if (*first == '.') {
    ++first;
    take_digits(decimals);
  }
  const bool ends = *first != 'e' && *first != 'E' && (*first < '0' || *first > '9');
  if (!ends || number > kExact || digits + decimals == 0 || decimals > kMaxDecimals) return nullptr;
  value = static_cast<double>(number) / kPowersOfTen[decimals];
  return first;
}

}  // namespace

const char* scan_decimal(const char* first, const char* last, double& value) {
  const bool negative = *first == '-';
  if (negative || *first == '+') ++first;
  // from_chars would accept a second sign, "inf" and "nan".
  if (*first != '.' && (*first < '0' || *first > '9')) return nullptr;
  double magnitude = 0;
  const char* end = scan_short(first, magnitude);
  if (end == nullptr) {
    const auto result = std::from_chars(first, last, magnitude);
    if (result.ec != std::errc() || !std::isfinite(magnitude)) return nullptr;
    end = result.ptr;
  }
  value = negative ? -magnitude : magnitude;
  return end;
}

char* print_fixed(double value, int decimals, char* out) {
  constexpr double kMaxFixed = 1e18;  // with nine decimals it takes 29 characters
  char* const max = out + kLongestDecimal;
  if (!(std::fabs(value) < kMaxFixed)) return std::to_chars(out, max, value).ptr;
  char* end = std::to_chars(out, max, value, std::chars_format::fixed, decimals).ptr;
  if (decimals > 0) {
    while (end[-1] == '0') --end;
    if (end[-1] == '.') --end;
  }
  if (std::string_view(out, static_cast<std::size_t>(end - out)) != "-0") return end;
  *out = '0';
  return out + 1;
}

}  // namespace fogcomp::recording
