#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/exponential_table.hpp"
#include "core/fixed_point/logarithm.hpp"
#include "core/fixed_point/logarithm_table.hpp"
#include "core/fixed_point/sine.hpp"
#include "core/fixed_point/sine_table.hpp"
#include "support/overflow_guard.hpp"

namespace {

constexpr long double kTwoPi = 6.283185307179586476925286766559L;

std::int64_t rounded(long double value, int fraction) {
  return std::llround(std::ldexp(value, fraction));
}

TEST(SineTable, HoldsTheRoundedFunctionAndConstants) {
  for (int i = 0; i <= 16; ++i) {
    EXPECT_EQ(fog::kSineTable[i], rounded(std::sin(kTwoPi * i / 64), 30)) << i;
  }
  EXPECT_EQ(rounded(kTwoPi, 28), 1686629713);
  EXPECT_EQ(rounded(1 / kTwoPi, 32), 683565276);  // expression_bank.hpp
  EXPECT_EQ(rounded(1.0L / 6, 30), 178956971);
  EXPECT_EQ(rounded(1.0L / 24, 30), 44739243);
}

TEST(Sine, DropsWholeTurns) {
  using Turns = fog::Fixed<std::int64_t, 47>;
  const std::int64_t turn = std::int64_t{1} << 47;
  for (const std::int64_t turns : {-50, -1, 0, 1, 54}) {
    const auto value = fog::sine_cosine_of_turns(Turns::from_raw(turns * turn + turn / 8));
    EXPECT_NEAR(std::ldexp(value.sine.raw(), -30), std::sqrt(0.5), 5e-9) << turns;
    EXPECT_NEAR(std::ldexp(value.cosine.raw(), -30), std::sqrt(0.5), 5e-9) << turns;
  }
}

TEST(ExponentialTable, HoldsTheRoundedFunctionAndConstants) {
  for (int i = 0; i < 16; ++i) {
    EXPECT_EQ(fog::kExponentialTable[i], rounded(std::exp2(-i / 16.0L), 30)) << i;
  }
  EXPECT_EQ(rounded(1 / std::log(2.0L), 30), 1549082005);
  EXPECT_EQ(rounded(std::log(2.0L), 31), 1488522236);
}

TEST(Exponential, IsOneBelowZeroAndZeroAtTheEnd) {
  EXPECT_EQ(fog::exponential_decay({}).raw(), 1 << 30);
  EXPECT_EQ(fog::exponential_decay(fog::Fixed<std::int32_t, 26>::lowest()).raw(), 1 << 30);
  EXPECT_EQ(fog::exponential_decay(fog::Fixed<std::int32_t, 26>::highest()).raw(), 0);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(LogarithmTable, HoldsTheRoundedFunctionAndConstants) {
  for (int i = 0; i <= 16; ++i) {
    const long double node = 1 + i / 16.0L;
    EXPECT_EQ(fog::kLogarithmTable[i], rounded(std::log(node), 30)) << i;
    EXPECT_EQ(fog::kReciprocalTable[i], rounded(1 / node, 30)) << i;
  }
  EXPECT_EQ(rounded(std::log(2.0L), 40), 762123384786);
  EXPECT_EQ(rounded(1.0L / 3, 30), 357913941);
  EXPECT_EQ(rounded(1.0L / 5, 30), 214748365);
}

TEST(Logarithm, OfOneIsZero) {
  EXPECT_EQ(fog::natural_logarithm(1, 0).raw(), 0);
  EXPECT_EQ(fog::natural_logarithm(std::int64_t{1} << 62, 62).raw(), 0);
}

}  // namespace
