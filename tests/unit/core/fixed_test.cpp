#include "core/fixed_point/fixed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "core/fixed_point/dual_product.hpp"
#include "core/fixed_point/words.hpp"
#include "support/overflow_guard.hpp"

namespace {

using fog::Fixed;
using fog::round_divide;
using fog::round_shift;
using Q16 = Fixed<std::int32_t, 16>;
using Q20 = Fixed<std::int32_t, 20>;
using Q28 = Fixed<std::int32_t, 28>;

TEST(RoundShift, RoundsToNearestWithHalvesUpwardsForEverySixteenBitValue) {
  for (int bits = 0; bits < 16; ++bits) {
    for (std::int32_t value = -32768; value <= 32767; ++value) {
      const auto expected = static_cast<std::int32_t>(std::floor(std::ldexp(value, -bits) + 0.5));
      ASSERT_EQ(round_shift(value, bits), expected) << value << " >> " << bits;
    }
  }
}

TEST(RoundShift, DoesNotOverflowAtTheEndsOfTheRange) {
  EXPECT_EQ(round_shift(INT32_MAX, 1), 0x40000000);
  EXPECT_EQ(round_shift(INT32_MIN, 1), -0x40000000);
  EXPECT_EQ(round_shift(INT64_MAX, 62), 2);
  EXPECT_EQ(round_shift(INT64_MIN, 63), -1);
}

TEST(FloorShift, RoundsDownForEverySixteenBitValueSignedAndUnsigned) {
  for (int bits = 0; bits < 16; ++bits) {
    for (std::int32_t value = -32768; value <= 32767; ++value) {
      const double expected = std::floor(std::ldexp(value, -bits));
      ASSERT_EQ(fog::floor_shift(value, bits), expected) << value << " >> " << bits;
      if (value >= 0) {
        ASSERT_EQ(fog::floor_shift(static_cast<std::uint32_t>(value), bits), expected) << value;
      }
    }
  }
  EXPECT_EQ(fog::floor_shift(UINT64_MAX, 63), 1U);
}

TEST(Words, AMagnitudeIsThatOfTheLowestNumberToo) {
  EXPECT_EQ(fog::magnitude_of(INT32_MIN), 0x80000000U);
  EXPECT_EQ(fog::magnitude_of(-5), 5U);
  EXPECT_EQ(fog::magnitude_of(INT32_MAX), 0x7FFFFFFFU);
}

TEST(Words, HalvesAndPairsComeBackAsTheyWentIn) {
  for (const std::int32_t upper : {0, 1, -1, 32767, -32768}) {
    for (const std::int32_t lower : {0, 1, -1, 32767, -32768}) {
      const std::uint32_t word = fog::pack_halves(fog::lower_half(lower), upper);
      EXPECT_EQ(static_cast<std::int16_t>(word % 65536U), lower);
      EXPECT_EQ(static_cast<std::int16_t>(word / 65536U), upper);
    }
  }
  for (const std::int32_t first : {0, -1, INT32_MIN, INT32_MAX}) {
    for (const std::int32_t second : {0, -1, INT32_MIN, INT32_MAX}) {
      const fog::RegisterPair pair(fog::RegisterPair::of(first, second));
      EXPECT_EQ(pair.first(), first);
      EXPECT_EQ(pair.second(), second);
    }
  }
}

TEST(Words, AnUpperWordIsTheSumRoundedOnceWithHalvesUpwards) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto upper = static_cast<std::int32_t>(random()) / 4;
    const std::int64_t added = fog::floor_shift(static_cast<std::int64_t>(random()), 2 + i % 40);
    ASSERT_EQ(fog::upper_word(fog::sum_of_upper_word(upper) + added),
              upper + round_shift(added, 32))
        << upper << " + " << added;
  }
}

TEST(SaturatingShift, IsTheFloorOfTheShiftedValueClipped) {
  std::mt19937_64 random(1);
  const auto expected = [](std::int64_t value, int bits) {
    return fog::saturate<std::int32_t>(fog::floor_shift(value, bits));
  };
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t value = fog::floor_shift(static_cast<std::int64_t>(random()), i % 40);
    ASSERT_EQ(fog::saturating_shift<31>(value), expected(value, 31)) << value;
    ASSERT_EQ(fog::saturating_shift<25>(value), expected(value, 25)) << value;
    ASSERT_EQ(fog::saturating_shift<1>(value), expected(value, 1)) << value;
  }
  for (const std::int64_t end : {std::int64_t{INT32_MAX}, std::int64_t{INT32_MIN}}) {
    for (std::int64_t beside = -1; beside <= 1; ++beside) {
      const std::int64_t value = (end + beside) * (std::int64_t{1} << 25);
      ASSERT_EQ(fog::saturating_shift<25>(value), expected(value, 25)) << value;
    }
  }
}

TEST(DualProduct, AddsTheProductsOfTheHalvesStraightOrCrossed) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int32_t> half(-8192, 8191);  // sums stay within 32 bits
  for (int i = 0; i < 10000; ++i) {
    const std::int32_t a_low = half(random), a_high = half(random);
    const std::int32_t b_low = half(random), b_high = half(random);
    const auto word = [](std::int32_t low, std::int32_t high) {
      return (static_cast<std::uint32_t>(high) << 16U) |
             (static_cast<std::uint32_t>(low) & 0xFFFFU);
    };
    const std::uint32_t a = word(a_low, a_high), b = word(b_low, b_high);
    ASSERT_EQ(fog::add_dual_product(a, b, i), i + a_low * b_low + a_high * b_high);
    ASSERT_EQ(fog::add_crossed_product(a, b, i), i + a_low * b_high - a_high * b_low);
  }
}

// Estimates of a digit are too large where the denominator's lower half is.
TEST(Divide, IsTheProcessorsOwn) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint64_t numerator = random() >> (random() % 64U);
    auto denominator = static_cast<std::uint32_t>((random() | 1U) >> (random() % 32U));
    if (i % 4 == 1) denominator |= 0x80000000U;
    if (i % 4 == 2) denominator |= 0x0000FFFFU;
    if (i % 4 == 3) denominator = 0x80000000U | (denominator & 0xFFFFU);
    denominator = std::max(denominator, 1U);
    ASSERT_EQ(fog::divide(numerator, denominator), numerator / denominator)
        << numerator << " / " << denominator;
  }
}

TEST(RoundDivide, RoundsLikeRoundShift) {
  for (std::int64_t numerator = -1000; numerator <= 1000; ++numerator) {
    for (std::int32_t denominator = 1; denominator < 40; ++denominator) {
      const double exact = static_cast<double>(numerator) / denominator;
      ASSERT_EQ(round_divide(numerator, denominator), std::floor(exact + 0.5));
    }
  }
}

TEST(Fixed, MultipliesExactly) {
  const auto product = Q16::from_raw(INT32_MIN) * Q16::from_raw(INT32_MIN);
  static_assert(decltype(product)::fractional_bits == 32);
  EXPECT_EQ(product.raw(), std::int64_t{1} << 62);
}

TEST(Fixed, ChangesFormatByRoundingAndClipsOnlyWhereItSaysSo) {
  EXPECT_EQ(fog::round_to<Q16>(Q20::from_raw(24)).raw(), 2);    // 1.5 -> 2
  EXPECT_EQ(fog::round_to<Q16>(Q20::from_raw(-24)).raw(), -1);  // -1.5 -> -1
  EXPECT_EQ(fog::round_to<Q20>(Q16::from_raw(-3)).raw(), -48);
  EXPECT_EQ(fog::saturate_to<Q28>(fog::from_integer<Q16>(100)), Q28::highest());
  EXPECT_EQ(fog::saturate_to<Q28>(fog::from_integer<Q16>(-100)), Q28::lowest());
  EXPECT_EQ(fog::saturate_to<Q28>(fog::from_integer<Q16>(-3)).raw(), -3 * (1 << 28));
}

TEST(Fixed, WidensTheRangeOfASaturatedProduct) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto a = Q28::from_raw(static_cast<std::int32_t>(random()));
    const auto b = Q20::from_raw(static_cast<std::int32_t>(random()));
    const long double exact = std::ldexp(static_cast<long double>(a.raw()) * b.raw(), -48 + 16);
    const long double clipped =
        std::min(std::max(std::floor(exact + 0.5L), -2147483648.0L), 2147483647.0L);
    ASSERT_EQ(fog::saturate_to<Q16>(a * b).raw(), static_cast<std::int64_t>(clipped));
  }
}

// On the board nothing else happens.
TEST(Fixed, WhatDoesNotFit_Wraps) {
  EXPECT_EQ(fog::shift_left(INT32_MAX, 1), -2);
  EXPECT_EQ(fog::shift_left(INT32_MIN, 1), 0);
  using Narrow = fog::Fixed<std::int32_t, 4>;
  using Wide = fog::Fixed<std::int64_t, 4>;
  constexpr std::int64_t kTwo32 = std::int64_t{1} << 32U;
  EXPECT_EQ(fog::round_to<Narrow>(Wide::from_raw(5)).raw(), 5);
  EXPECT_EQ(fog::round_to<Narrow>(Wide::from_raw(kTwo32 + 5)).raw(), 5);
  EXPECT_EQ(fog::round_to<Narrow>(Wide::from_raw(5 - kTwo32)).raw(), 5);
  fog::test::forget_overflows();
}

TEST(CheckedFixed, CountsAnOverflowAndKnowsItsPlace) {
  if (!fog::test::kChecked) GTEST_SKIP() << "not a checked build (preset tests)";
  const std::uint32_t before = fog::test::overflows();
  const auto sum = Q16::highest() + Q16::from_raw(1);
  EXPECT_EQ(sum, Q16::lowest());  // wraps, as on the board
  EXPECT_EQ(fog::test::overflows(), before + 1);
  fog::test::forget_overflows();
}

}  // namespace
