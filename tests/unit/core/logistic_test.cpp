#include "core/fixed_point/logistic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace {

TEST(LogisticTable, HoldsTheRoundedFunction) {
  for (int i = -128; i <= 128; ++i) {
    const long double exact = std::ldexp(1 / (1 + std::exp(-i / 8.0L)) - 0.5L, 31);
    EXPECT_EQ(fog::kLogisticNodes[i], std::llround(exact)) << i;
  }
}

}  // namespace
