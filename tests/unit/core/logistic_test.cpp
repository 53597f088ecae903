#include "core/fixed_point/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/fixed_point/logistic_table.hpp"
#include "support/overflow_guard.hpp"

namespace {

using fog::ActivationInput;

double real(fog::ActivationOutput value) {
  return std::ldexp(value.raw(), -30);
}

TEST(LogisticTable, HoldsTheRoundedFunction) {
  for (int i = 0; i <= 256; ++i) {
    const long double exact = std::ldexp(1 / (1 + std::exp(-i / 16.0L)) - 0.5L, 31);
    EXPECT_EQ(fog::kLogisticTable[i], std::llround(exact)) << i;
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

}  // namespace
