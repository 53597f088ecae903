#include "compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fogcomp::compare {
namespace {

using Values = std::vector<double>;

constexpr std::size_t kShareRows = 400;

template <class Value>
Values rows(Value value) {
  Values values;
  for (std::size_t i = 0; i < kShareRows; ++i) {
    values.push_back(value(6.283185307179586 * static_cast<double>(i) / kShareRows));
  }
  return values;
}

// Sine and cosine over whole periods are orthogonal: the shares are those of the variances.
TEST(EffectShares, AddUpForEffectsThatDoNotGoTogether) {
  const Values sine = rows([](double x) { return 2 * std::sin(x); });
  const Values cosine = rows([](double x) { return std::cos(x); });
  const Values measured = rows([](double x) { return 2 * std::sin(x) + std::cos(x) + 7; });
  const Values residual(kShareRows, 7);
  const auto a = share_of("a", sine, residual, measured);
  const auto b = share_of("b", cosine, residual, measured);
  EXPECT_NEAR(a.share, 0.8, 1e-9);
  EXPECT_NEAR(b.share, 0.2, 1e-9);
  EXPECT_NEAR(a.std_dph, std::sqrt(2.0), 0.01);
  EXPECT_NEAR(a.mean_dph, 0, 1e-9);
}

// Two halves of one sine: leaving out either adds a quarter.
TEST(EffectShares, OfEffectsThatGoTogetherNeedNotAddUp) {
  const Values half = rows([](double x) { return std::sin(x); });
  const Values measured = rows([](double x) { return 2 * std::sin(x); });
  const auto share = share_of("half", half, Values(kShareRows, 0), measured);
  EXPECT_NEAR(share.share, 0.25, 1e-9);
}

TEST(EffectShares, AreNegativeForAnEffectThatDoesHarm) {
  const Values harm = rows([](double x) { return 0.5 * std::sin(x); });
  const Values residual = rows([](double x) { return -0.5 * std::sin(x); });
  const Values measured = rows([](double x) { return std::cos(x); });
  EXPECT_NEAR(share_of("harm", harm, residual, measured).share, -0.25, 1e-9);
}

TEST(EffectShares, GiveAConstantNoShareOfTheVariance) {
  const Values measured = rows([](double x) { return 3 + std::sin(x); });
  const Values residual = rows([](double x) { return std::sin(x); });
  const auto share = share_of("bias", Values(kShareRows, 3), residual, measured);
  EXPECT_NEAR(share.share, 0, 1e-9);
  EXPECT_NEAR(share.mean_dph, 3, 1e-9);
}

}  // namespace
}  // namespace fogcomp::compare
