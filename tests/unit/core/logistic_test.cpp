#include "core/fixed_point/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/overflow_guard.hpp"

namespace {

using fog::ActivationInput;

double real(fog::ActivationOutput value) {
  return std::ldexp(value.raw(), -30);
}

TEST(LogisticTable, HoldsTheRoundedFunction) {
  for (int i = -128; i <= 128; ++i) {
    const long double exact = std::ldexp(1 / (1 + std::exp(-i / 8.0L)) - 0.5L, 31);
    EXPECT_EQ(fog::kLogisticNodes[i], std::llround(exact)) << i;
  }
}

// 2^32 arguments in steps of 509, a prime, and both ends: 8.4 million points.
template <class Visit>
void sweep(Visit visit) {
  for (std::int64_t raw = INT32_MIN; raw <= INT32_MAX; raw += 509) {
    visit(static_cast<std::int32_t>(raw));
  }
  visit(INT32_MAX);
}

TEST(Logistic, IsWithin1e8OverItsWholeRange) {
  double worst = 0;
  sweep([&](std::int32_t raw) {
    const double exact = 1 / (1 + std::exp(-std::ldexp(raw, -27)));
    worst = std::max(worst, std::abs(real(fog::logistic(ActivationInput::from_raw(raw))) - exact));
  });
  EXPECT_LE(worst, 1e-8);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(HyperbolicTangent, IsWithin2e8UpTo8And23e8BeyondOverItsWholeRange) {
  double worst = 0;
  double worst_beyond = 0;
  sweep([&](std::int32_t raw) {
    const double x = std::ldexp(raw, -27);
    const double error =
        std::abs(real(fog::hyperbolic_tangent(ActivationInput::from_raw(raw))) - std::tanh(x));
    double& kept = std::abs(x) <= 8 ? worst : worst_beyond;
    kept = std::max(kept, error);
  });
  EXPECT_LE(worst, 2e-8);
  EXPECT_LE(worst_beyond, 2.3e-7);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

// What a network's logsig and tansig are made of: errors of these are half of it, and it.
TEST(SymmetricLogistic, IsWithin2e7UpTo16And3e7BeyondOverItsWholeRange) {
  double worst = 0;
  double worst_beyond = 0;
  // Within +-16, then up to +-2^24, where the upper word is of any size.
  for (const int fraction : {35, 15}) {
    sweep([&](std::int32_t raw) {
      const auto place = fog::NodePlace::from_raw(256 * std::int64_t{raw} + (raw & 255));
      const double x = std::ldexp(static_cast<double>(place.raw()), -fraction);
      const auto shifted =
          fog::NodePlace::from_raw(place.raw() * (std::int64_t{1} << (35 - fraction)));
      const double error = std::abs(real(fog::symmetric_logistic(shifted)) - std::tanh(x / 2));
      double& kept = std::abs(x) <= 16 ? worst : worst_beyond;
      kept = std::max(kept, error);
    });
  }
  EXPECT_LE(worst, 2e-7);
  EXPECT_LE(worst_beyond, 3e-7);
  EXPECT_EQ(fog::test::overflows(), 0U);
}

}  // namespace
