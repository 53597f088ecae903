#include <gtest/gtest.h>

#include <cstdint>

#include "support/overflow_guard.hpp"
#include "sweep/core_functions.hpp"
#include "sweep/core_products.hpp"

namespace {

// A sample of what bench/core_functions.cpp does in full: arguments in steps of a prime, the ends
// and their neighbours.
TEST(CoreFunctions, ErrorsAreWithinTheDocumentedOnes) {
  constexpr std::int64_t kStride = 2053;
  for (const auto& function : fog::test::core_functions()) {
    fog::test::Worst worst = function.sweep(function.first, function.last, kStride);
    worst.join(function.sweep(function.first, function.first + 2 * kStride, 1));
    worst.join(function.sweep(function.last - 2 * kStride, function.last, 1));
    EXPECT_LE(worst.error, function.max_error) << function.name << " at " << worst.at;
    EXPECT_LE(worst.largest_fall, function.max_fall) << function.name;
  }
  EXPECT_EQ(fog::test::overflows(), 0U);
}

TEST(CoreProducts, AreExactAtEdgesAndOnDraws) {
  for (const auto& function : fog::test::core_products()) {
    EXPECT_EQ(function.wrong_edges(), 0) << function.name;
    EXPECT_EQ(function.wrong_draws(1, 100'000), 0) << function.name;
  }
}

}  // namespace
