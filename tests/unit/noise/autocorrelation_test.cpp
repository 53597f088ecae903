#include "noise/autocorrelation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/compare/slow_noise.hpp"

namespace fogcomp::noise {
namespace {

constexpr std::size_t kCount = 40000;

TEST(Autocorrelation, IsThatOfTheProcess) {
  const auto values = fog::test::slow_noise(kCount, 0.8, 1);
  for (const std::size_t lag : {1U, 2U, 5U}) {
    EXPECT_NEAR(autocorrelation(values, {{0, kCount}}, lag), std::pow(0.8, lag), 0.03);
  }
  // (1 + phi) / (1 - phi)
  EXPECT_NEAR(correlated_values(values, {{0, kCount}}), 9, 0.9);
}

TEST(Autocorrelation, OfWhiteNoiseStaysInItsBand) {
  const double band = 2 / std::sqrt(static_cast<double>(kCount));
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto values = fog::test::slow_noise(kCount, 0, seed);
    if (std::abs(autocorrelation(values, {{0, kCount}}, 1)) < band) ++inside;
  }
  EXPECT_GE(inside, 88);  // 95 expected, sigma 2
  EXPECT_LE(inside, 100);
}

// The values alternate but for one gap in the middle, across which no pair is formed.
TEST(Autocorrelation, FormsNoPairAcrossAGap) {
  const std::vector<double> values{1, -1, 1, -1, -1, 1, -1, 1};
  EXPECT_DOUBLE_EQ(autocorrelation(values, {{0, 4}, {4, 8}}, 1), -1);
  EXPECT_GT(autocorrelation(values, {{0, 8}}, 1), -1);
}

TEST(Autocorrelation, OfNothingOrAConstantIsZero) {
  EXPECT_EQ(autocorrelation({}, {}, 1), 0);
  EXPECT_EQ(autocorrelation({2, 2, 2}, {{0, 3}}, 1), 0);
  EXPECT_EQ(correlated_values({2, 2, 2}, {{0, 3}}), 1);
}

}  // namespace
}  // namespace fogcomp::noise
