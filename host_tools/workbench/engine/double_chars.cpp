#include "workbench/engine/double_chars.hpp"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#ifdef __EMSCRIPTEN__
#include <emscripten.h>

// A browser finds the shortest digits many times faster than trying them by the C library.
// NOLINTNEXTLINE: emscripten's way to call the page
EM_JS(void, print_scientific, (double value, char* text),
      { stringToUTF8(value.toExponential(), text, 40); });
#else
// For the unit test of all the rest.
static void print_scientific(double value, char* text) {
  *std::to_chars(text, text + 40, value, std::chars_format::scientific).ptr = 0;
}
#endif

namespace fogcomp::workbench {
namespace {

struct Decimal {
  std::string digits;  // the first one is not 0
  int exponent = 0;    // of the first digit
};

// The shortest that reads back as `value`, of those the closest.
Decimal shortest(double value) {
  char text[40];
  print_scientific(value, text);
  const char* const mark = std::strchr(text, 'e');
  Decimal decimal;
  for (const char* at = text; at != mark; ++at) {
    if (*at != '.') decimal.digits += *at;
  }
  decimal.exponent = std::atoi(mark + 1);
  return decimal;
}

std::string fixed_text(const Decimal& decimal, double value) {
  const auto count = static_cast<int>(decimal.digits.size());
  if (decimal.exponent < 0)
    return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') +
           decimal.digits;
  if (decimal.exponent + 1 < count) {
    std::string text = decimal.digits;
    return text.insert(static_cast<std::size_t>(decimal.exponent) + 1, ".");
  }
  char whole[400];  // every digit of a whole number, as the library prints it
  std::snprintf(whole, sizeof whole, "%.0f", value);
  return whole;
}

std::string scientific_text(const Decimal& decimal) {
  std::string text = decimal.digits.substr(0, 1);
  if (decimal.digits.size() > 1) text += "." + decimal.digits.substr(1);
  char exponent[8];
  std::snprintf(exponent, sizeof exponent, "e%+03d", decimal.exponent);
  return text + exponent;
}

std::string text_of(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return "inf";
  if (value == 0) return "0";
  const Decimal decimal = shortest(value);
  const std::string scientific = scientific_text(decimal);
  if (std::abs(decimal.exponent) > 30) return scientific;
  const std::string fixed = fixed_text(decimal, value);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// End of the decimal number at `first`; `first` if there is none.
const char* end_of_number(const char* first, const char* last) {
  const char* at = first;
  if (at != last && *at == '-') ++at;
  const char* const digits = at;
  while (at != last && is_digit(*at)) ++at;
  auto count = at - digits;
  if (at != last && *at == '.') {
    const char* const fraction = ++at;
    while (at != last && is_digit(*at)) ++at;
    count += at - fraction;
  }
  if (count == 0) return first;
  if (at == last || (*at != 'e' && *at != 'E')) return at;
  const char* exponent = at + 1;
  if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
  if (exponent == last || !is_digit(*exponent)) return at;
  while (exponent != last && is_digit(*exponent)) ++exponent;
  return exponent;
}

}  // namespace

char* print_shortest(char* first, double value) {
  const std::string text = (std::signbit(value) ? "-" : "") + text_of(std::fabs(value));
  return std::copy(text.begin(), text.end(), first);
}

char* print_fixed(char* first, char* last, double value, int decimals) {
  return first +
         std::snprintf(first, static_cast<std::size_t>(last - first), "%.*f", decimals, value);
}

std::from_chars_result scan(const char* first, const char* last, double& value) {
  const char* const end = end_of_number(first, last);
  if (end == first) return {first, std::errc::invalid_argument};
  const std::string text(first, end);
  errno = 0;
  const double read = std::strtod(text.c_str(), nullptr);
  if (errno == ERANGE && (read == 0 || std::isinf(read))) {
    return {end, std::errc::result_out_of_range};
  }
  value = read;
  return {end, std::errc()};
}

}  // namespace fogcomp::workbench
