#include "recording/fixed_decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace fogcomp {
namespace {

constexpr std::array<double, 10> kPowerOfTen{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
constexpr double kMostUnits = 9007199254740992.0;  // 2^53: doubles count in ones up to here

}  // namespace

char* print_fixed(double value, int decimals, char* out) {
  const double units = std::fabs(value) * kPowerOfTen[static_cast<std::size_t>(decimals)];
  if (!(units < kMostUnits)) return std::to_chars(out, out + kLongestDecimal, value).ptr;
  auto rest = static_cast<std::uint64_t>(units + 0.5);

  int places = decimals;
  while (places > 0 && rest % 10 == 0) {
    rest /= 10;
    --places;
  }
  if (rest != 0 && std::signbit(value)) *out++ = '-';

  std::array<char, 24> reversed;  // 2^53 has 16 digits; with point and leading zeros still below
  std::size_t length = 0;
  for (int place = 0; place < places; ++place) {
    reversed[length++] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  }
  if (places > 0) reversed[length++] = '.';
  do {
    reversed[length++] = static_cast<char>('0' + rest % 10);
    rest /= 10;
  } while (rest != 0);
  while (length > 0) *out++ = reversed[--length];
  return out;
}

}  // namespace fogcomp
