#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/acquisition/calibration.hpp"
#include "core/fixed_point/dual_product.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/rounded_product.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/fixed_point/share.hpp"
#include "core/fixed_point/shift.hpp"

namespace fog::test {

// Functions of the core with two or more arguments, against integers of 128 bits or the real
// function: at all combinations of their edges, and on draws of every magnitude.

struct CoreProduct {
  const char* name;
  std::int64_t (*wrong_edges)();
  std::int64_t (*wrong_draws)(std::uint64_t seed, std::int64_t draws);
};

namespace detail {

__extension__ using Int128 = __int128;

inline Int128 floor_shifted(Int128 value, int bits) {
  return value >> bits;
}
inline Int128 rounded_shifted(Int128 value, int bits) {
  return bits == 0 ? value : (value + (Int128{1} << (bits - 1))) >> bits;
}
template <class Int>
Int128 clipped(Int128 value) {
  constexpr Int128 kMin = std::numeric_limits<Int>::min();
  constexpr Int128 kMax = std::numeric_limits<Int>::max();
  return value < kMin ? kMin : (kMax < value ? kMax : value);
}

struct RoundedProduct {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const int bits = static_cast<int>(more % 63U);
    return rounded_product(a, b, bits) == rounded_shifted(Int128{a} * b, bits);
  }
};

struct HighProduct {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t /*more*/) {
    using Value = Fixed<std::int32_t, 31>;
    return high_product(Value::from_raw(a), Value::from_raw(b)).raw() ==
           floor_shifted(Int128{a} * b, 32);
  }
};

struct SaturatingDifference {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t /*more*/) {
    return saturating_difference(a, b) == clipped<std::int32_t>(Int128{a} - b);
  }
};

struct SaturatingShift {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const auto value = static_cast<std::int64_t>(static_cast<std::uint64_t>(std::int64_t{a} * b) ^
                                                 std::uint64_t{more} << 16U);
    return saturating_shift<31>(value) == clipped<std::int32_t>(floor_shifted(value, 31)) &&
           saturating_shift<14>(value) == clipped<std::int32_t>(floor_shifted(value, 14)) &&
           saturating_shift<1>(value) == clipped<std::int32_t>(floor_shifted(value, 1));
  }
};

struct RoundDivide {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const std::int32_t denominator = std::max(1, b & INT32_MAX);
    const std::int64_t numerator = (std::int64_t{a} * static_cast<std::int64_t>(more)) >> 2;
    const Int128 doubled = Int128{2} * numerator + denominator;
    const Int128 divisor = Int128{2} * denominator;
    const Int128 quotient = doubled / divisor;
    return round_divide(numerator, denominator) ==
           (quotient * divisor > doubled ? quotient - 1 : quotient);
  }
};

struct CalibratedRate {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const CalibrationParameters calibration{(b & INT32_MAX) | 1 << 30,
                                            static_cast<int>(more % 63U)};
    return calibrated_rate(calibration, a).raw() ==
           clipped<std::int32_t>(
               rounded_shifted(Int128{a} * calibration.multiplier, calibration.shift));
  }
};

struct FormatChange {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t /*more*/) {
    using Wide = Fixed<std::int64_t, 50>;
    const auto wide = Wide::from_raw(std::int64_t{a} * b);
    return saturate_to<Fixed<std::int32_t, 28>>(wide).raw() ==
               clipped<std::int32_t>(rounded_shifted(wide.raw(), 22)) &&
           saturate_to<Fixed<std::int32_t, 31>>(Fixed<std::int32_t, 25>::from_raw(a)).raw() ==
               clipped<std::int32_t>(Int128{a} * 64);
  }
};

struct DualProduct {
  // Sums stay within 32 bits for halves below 2^15 and a sum below 2^30.
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const auto low = [](std::int32_t word) {
      return std::int64_t{static_cast<std::int16_t>(word)};
    };
    const auto high = [](std::int32_t word) {
      return std::int64_t{static_cast<std::int16_t>(static_cast<std::uint32_t>(word) >> 16U)};
    };
    const auto sum = static_cast<std::int32_t>(more >> 2U) - (1 << 29);
    const std::int64_t dual = sum + low(a) * low(b) + high(a) * high(b);
    const std::int64_t crossed = sum + low(a) * high(b) - high(a) * low(b);
    const auto first = static_cast<std::uint32_t>(a);
    const auto second = static_cast<std::uint32_t>(b);
    return (dual != clipped<std::int32_t>(dual) || add_dual_product(first, second, sum) == dual) &&
           (crossed != clipped<std::int32_t>(crossed) ||
            add_crossed_product(first, second, sum) == crossed);
  }
};

struct Share {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t /*more*/) {
    using Raw = Fixed<std::int32_t, 0>;
    const std::int32_t whole = std::max(1, b & INT32_MAX);
    const std::int32_t part = a % (whole == INT32_MAX ? whole : whole + 1);
    const Int128 lsbs = (Int128{part} * (Int128{1} << 31)) -
                        Int128{ShareOf(Raw::from_raw(whole))(Raw::from_raw(part)).raw()} * whole;
    return lsbs > Int128{-3} * whole && lsbs < Int128{3} * whole;
  }
};

struct LogarithmOf64Bits {
  static bool right(std::int32_t a, std::int32_t b, std::uint32_t more) {
    const std::uint64_t bits =
        std::uint64_t{static_cast<std::uint32_t>(a)} << 32U | static_cast<std::uint32_t>(b);
    const auto raw = static_cast<std::int64_t>(bits >> 1U >> more % 62U) | 1;
    const int fraction = static_cast<int>(more >> 8U) % 64;
    const double exact = std::log(static_cast<double>(raw)) - fraction * 0.693147180559945309417;
    const double held = std::clamp(exact, -32.0, std::ldexp(INT32_MAX, -26));
    return std::abs(std::ldexp(natural_logarithm(raw, fraction).raw(), -26) - held) <= 1e-8;
  }
};

template <class Function>
std::int64_t wrong_edges() {
  constexpr std::int32_t kEdges[] = {INT32_MIN,  INT32_MIN + 1,
                                     -(1 << 30), -65536,
                                     -32769,     -32768,
                                     -257,       -2,
                                     -1,         0,
                                     1,          2,
                                     3,          255,
                                     256,        32767,
                                     32768,      65535,
                                     65536,      (1 << 30) - 1,
                                     1 << 30,    INT32_MAX - 1,
                                     INT32_MAX};
  constexpr std::uint32_t kMore[] = {0,         1, 2, 31, 32, 61, 62, 1U << 30U, UINT32_MAX - 1,
                                     UINT32_MAX};
  std::int64_t wrong = 0;
  for (const std::int32_t a : kEdges) {
    for (const std::int32_t b : kEdges) {
      for (const std::uint32_t more : kMore) wrong += Function::right(a, b, more) ? 0 : 1;
    }
  }
  return wrong;
}

template <class Function>
std::int64_t wrong_draws(std::uint64_t seed, std::int64_t draws) {
  std::mt19937_64 random(seed);
  std::int64_t wrong = 0;
  const auto of_any_size = [](std::uint64_t bits, std::uint64_t size) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits)) >> (size & 31U);
  };
  for (std::int64_t i = 0; i < draws; ++i) {
    const std::uint64_t words = random();
    const std::uint64_t more = random();
    wrong +=
        Function::right(of_any_size(words, more >> 32U), of_any_size(words >> 32U, more >> 37U),
                        static_cast<std::uint32_t>(more))
            ? 0
            : 1;
  }
  return wrong;
}

template <class Function>
CoreProduct product(const char* name) {
  return {name, wrong_edges<Function>, wrong_draws<Function>};
}

}  // namespace detail

inline const std::array<CoreProduct, 10>& core_products() {
  static const std::array<CoreProduct, 10> all{{
      detail::product<detail::RoundedProduct>("rounded product"),
      detail::product<detail::HighProduct>("high product"),
      detail::product<detail::SaturatingDifference>("saturating difference"),
      detail::product<detail::SaturatingShift>("saturating shift"),
      detail::product<detail::RoundDivide>("rounded division"),
      detail::product<detail::CalibratedRate>("calibrated rate"),
      detail::product<detail::FormatChange>("change of format"),
      detail::product<detail::DualProduct>("dual product"),
      detail::product<detail::Share>("share, any part"),
      detail::product<detail::LogarithmOf64Bits>("logarithm of 64 bits"),
  }};
  return all;
}

}  // namespace fog::test
