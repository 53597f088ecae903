#include "recording/fixed_decimal.hpp"

#include <charconv>
#include <cmath>
#include <string_view>

namespace fogcomp::recording {

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
