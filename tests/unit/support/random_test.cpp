#include "support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fogcomp {
namespace {

// Means of the first three powers, of 200,000 values.
struct Moments {
  double mean = 0;
  double square = 0;
  double cube = 0;
};

template <class Draw>
Moments moments_of(Draw draw) {
  constexpr int kDraws = 200'000;
  Moments moments;
  for (int i = 0; i < kDraws; ++i) {
    const double value = draw();
    moments.mean += value / kDraws;
    moments.square += value * value / kDraws;
    moments.cube += value * value * value / kDraws;
  }
  return moments;
}

TEST(Random, GaussianHasItsMoments) {
  Random random(1, "moments");
  const Moments moments = moments_of([&] { return random.gaussian(); });
  EXPECT_NEAR(moments.mean, 0, 4 / std::sqrt(2e5));
  EXPECT_NEAR(moments.square, 1, 4 * std::sqrt(2 / 2e5));
  EXPECT_NEAR(moments.cube, 0, 4 * std::sqrt(15 / 2e5));
}

// E x = a, E x^2 = a (a + 1), E x^3 = a (a + 1) (a + 2).
TEST(Random, GammaHasItsMoments) {
  for (const double shape : {1.0, 1.5, 6.0, 500.0}) {
    Random random(1, "moments");
    const Moments moments = moments_of([&] { return random.gamma(shape); });
    EXPECT_NEAR(moments.mean, shape, 4 * std::sqrt(shape / 2e5)) << shape;
    EXPECT_NEAR(moments.square / (shape * (shape + 1)), 1, 0.02) << shape;
    EXPECT_NEAR(moments.cube / (shape * (shape + 1) * (shape + 2)), 1, 0.05) << shape;
  }
}

// A page and a shell draw the same numbers: these are of a GCC with glibc.
TEST(Random, DependsOnNoLibrary) {
  Random random(1, "noise alone");
  EXPECT_EQ(random.bits(), 12132224833381734782U);
  EXPECT_DOUBLE_EQ(random.uniform(), 0.75504802608174948);
  EXPECT_DOUBLE_EQ(random.gaussian(), -0.71265724116688367);
  EXPECT_DOUBLE_EQ(random.gamma(2.5), 1.4746612179850573);
}

}  // namespace
}  // namespace fogcomp
