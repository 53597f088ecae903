#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "core/fixed_point/overflow.hpp"

namespace fog {

// All shifts of numbers; other shifts only move bits (masks, bytes of a frame). Right shifts of
// negative numbers are arithmetic in C++20 and in GCC.

/// 2^bits. 0 <= bits < width of Int, one less if Int is signed.
template <typename Int>
constexpr Int power_of_two(int bits) {
  return static_cast<Int>(Int{1} << bits);
}

/// value / 2^bits, rounded to the nearest integer, halves upwards (towards +infinity): add half,
/// then shift arithmetically, as the Cortex-M4 instruction SMMULR does. 0 <= bits < width of Int;
/// no overflow for any value.
template <typename Int>
constexpr Int round_shift(Int value, int bits) {
  static_assert(std::is_signed_v<Int>);
  if (bits == 0) return value;
  // The highest dropped bit is the half that is added: no intermediate sum can overflow.
  return static_cast<Int>((value >> bits) + ((value >> (bits - 1)) & 1));
}

/// value / 2^bits, rounded down (towards -infinity). 0 <= bits < width of Int; no overflow. For a
/// sum that started with rounding_half() this equals round_shift of the rest.
template <typename Int>
constexpr Int floor_shift(Int value, int bits) {
  return static_cast<Int>(value >> bits);
}

/// Half of 2^bits: start value of a sum that floor_shift is to round. 1 <= bits.
template <typename Int>
constexpr Int rounding_half(int bits) {
  return power_of_two<Int>(bits - 1);
}

/// value * 2^bits. Wraps; a checked build reports overflow.
template <typename Int>
constexpr Int shift_left(Int value, int bits) {
  using Unsigned = std::make_unsigned_t<Int>;
  check_range(value <= (std::numeric_limits<Int>::max() >> bits) &&
              value >= (std::numeric_limits<Int>::min() >> bits));
  return static_cast<Int>(static_cast<Unsigned>(value) << bits);
}

/// The nearest value that a Narrow integer can hold.
template <typename Narrow, typename Wide>
constexpr Narrow saturate(Wide value) {
  static_assert(sizeof(Wide) >= sizeof(Narrow));
  const auto narrow = static_cast<Narrow>(value);
  if (Wide{narrow} == value) return narrow;
  return value < 0 ? std::numeric_limits<Narrow>::min() : std::numeric_limits<Narrow>::max();
}

/// saturate<std::int32_t>(floor_shift(value, kBits)), 0 < kBits < 32, in few instructions: one test
/// of the upper word's highest bits.
template <int kBits>
[[gnu::always_inline]] constexpr std::int32_t saturating_shift(std::int64_t value) {
  static_assert(kBits > 0 && kBits < 32);
  const auto upper = static_cast<std::int32_t>(value >> 32);
  // It fits where the upper word lies within +-2^(kBits - 1).
  if ((static_cast<std::uint32_t>(upper) + (std::uint32_t{1} << (kBits - 1))) >> kBits == 0) {
    return static_cast<std::int32_t>(value >> kBits);
  }
  return std::numeric_limits<std::int32_t>::max() ^ (upper >> 31);  // min where negative
}

/// numerator / denominator, rounded down; denominator > 0. Uses the 32-bit divisions of the
/// processor, because the compiler's 64-bit division takes 850 bytes. Two digits of 16 bits, Knuth
/// (The Art of Computer Programming, vol. 2, 4.3.1, algorithm D), after the upper half of the
/// quotient.
constexpr std::uint64_t divide(std::uint64_t numerator, std::uint32_t denominator) {
  constexpr std::uint32_t kDigit = 1U << 16U;
  const auto upper = static_cast<std::uint32_t>(numerator >> 32U);
  const int shift = __builtin_clz(denominator);
  const std::uint64_t rest =
      (std::uint64_t{upper % denominator} << 32U | static_cast<std::uint32_t>(numerator)) << shift;
  denominator <<= shift;  // its highest bit is set, so an estimate exceeds the digit by at most 2
  std::uint64_t quotient = upper / (denominator >> shift);
  auto remainder = static_cast<std::uint32_t>(rest >> 32U);
  for (int digit = 1; digit >= 0; --digit) {
    const auto next = static_cast<std::uint32_t>(rest >> (16 * digit)) % kDigit;
    std::uint32_t estimate = remainder / (denominator / kDigit);
    std::uint32_t left = remainder - estimate * (denominator / kDigit);
    while (left < kDigit &&
           (estimate >= kDigit || std::uint64_t{estimate} * (denominator % kDigit) >
                                      (std::uint64_t{left} << 16U | next))) {
      --estimate;
      left += denominator / kDigit;
    }
    remainder = remainder * kDigit + next - estimate * denominator;  // modulo 2^32
    quotient = quotient << 16U | estimate;
  }
  return quotient;
}

/// Largest |numerator| of round_divide: twice it, and a denominator, fit 64 bits.
constexpr std::int64_t kMaxDividend =
    (std::numeric_limits<std::int64_t>::max() - std::numeric_limits<std::int32_t>::max()) / 2;

/// numerator / denominator rounded to nearest, halves upwards, as round_shift does.
/// denominator > 0; |numerator| <= kMaxDividend.
constexpr std::int64_t round_divide(std::int64_t numerator, std::int32_t denominator) {
  const std::int64_t doubled = 2 * numerator + denominator;
  const std::uint32_t divisor = 2 * static_cast<std::uint32_t>(denominator);
  // Of a negative number, rounded down: -1 - (its magnitude - 1) / divisor.
  const std::int64_t negative = doubled >> 63;
  const auto quotient = divide(static_cast<std::uint64_t>(doubled ^ negative), divisor);
  return static_cast<std::int64_t>(quotient) ^ negative;
}

}  // namespace fog
