#include "core/fixed_point/dual_product.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "on_target/checks.hpp"
#include "on_target/pseudo_random.hpp"

namespace fog::checks {
namespace {

// From the definition, by division alone: floor((value + half) / divisor).
std::int64_t rounded_quotient(std::int64_t value, std::int64_t divisor) {
  const std::int64_t twice = 2 * value + divisor;
  std::int64_t quotient = twice / (2 * divisor);
  if (twice % (2 * divisor) < 0) --quotient;
  return quotient;
}

std::int64_t clipped(std::int64_t value) {
  if (value > INT32_MAX) return INT32_MAX;
  return value < INT32_MIN ? INT32_MIN : value;
}

std::int32_t low(std::uint32_t word) {
  const auto half = static_cast<std::int32_t>(word % 65536U);
  return half >= 32768 ? half - 65536 : half;
}
std::int32_t high(std::uint32_t word) {
  return low(word / 65536U);
}

}  // namespace

bool round_shift_rounds_halves_upwards() {
  for (int bits = 0; bits < 16; ++bits) {
    const std::int32_t divisor = std::int32_t{1} << bits;
    for (std::int32_t value = -32768; value <= 32767; value += 3) {
      if (round_shift(value, bits) != rounded_quotient(value, divisor)) return false;
    }
  }
  return round_shift(INT32_MAX, 1) == 0x40000000 && round_shift(INT32_MIN, 1) == -0x40000000 &&
         round_shift(INT64_MAX, 62) == 2 && round_shift(INT64_MIN, 63) == -1;
}

bool round_divide_rounds_halves_upwards() {
  PseudoRandom random;
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t numerator = std::int64_t{random.next_signed()} * (i % 1000);
    const auto denominator = static_cast<std::int32_t>(random.next() % 100000U) + 1;
    if (round_divide(numerator, denominator) != rounded_quotient(numerator, denominator)) {
      return false;
    }
  }
  return true;
}

bool saturation_clips_at_both_ends() {
  PseudoRandom random;
  for (int i = 0; i < 20000; ++i) {
    const std::int32_t a = random.next_signed();
    const std::int32_t b = random.next_signed();
    if (saturating_difference(a, b) != clipped(std::int64_t{a} - b)) return false;
    const std::int64_t wide = std::int64_t{a} * (b % 4096);
    if (saturate<std::int32_t>(wide) != clipped(wide)) return false;
    if (saturating_shift<12>(wide) != clipped((wide - (((wide % 4096) + 4096) % 4096)) / 4096)) {
      return false;
    }
  }
  return saturating_difference(INT32_MIN, 1) == INT32_MIN &&
         saturating_difference(INT32_MAX, -1) == INT32_MAX &&
         saturating_difference(0, INT32_MIN) == INT32_MAX;
}

bool dual_products_are_sums_of_half_products() {
  PseudoRandom random;
  for (int i = 0; i < 20000; ++i) {
    const std::uint32_t a = random.next() & 0x3FFF3FFFU;  // sums stay within 32 bits
    const std::uint32_t b = random.next() | 0xC000C000U;
    if (add_dual_product(a, b, i) != i + low(a) * low(b) + high(a) * high(b)) return false;
    if (add_crossed_product(a, b, i) != i + low(a) * high(b) - high(a) * low(b)) return false;
  }
  return true;
}

bool high_product_is_the_upper_word() {
  PseudoRandom random;
  constexpr std::int64_t kWord = std::int64_t{1} << 32;
  for (int i = 0; i < 20000; ++i) {
    const auto a = Fixed<std::int32_t, 31>::from_raw(random.next_signed());
    const auto b = Fixed<std::int32_t, 31>::from_raw(random.next_signed());
    const std::int64_t product = std::int64_t{a.raw()} * b.raw();
    const std::int64_t floor = (product - (((product % kWord) + kWord) % kWord)) / kWord;
    if (high_product(a, b).raw() != floor) return false;
  }
  return true;
}

}  // namespace fog::checks
