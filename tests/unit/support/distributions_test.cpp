#include "support/statistics.hpp"

#include <gtest/gtest.h>

namespace fogcomp {
namespace {

// Tables of Fisher's F.
TEST(VarianceRatio, ExceedsTheTabulatedOnesAsSeldomAsTheTablesSay) {
  EXPECT_NEAR(chance_of_variance_ratio(161.4476, 1, 1), 0.05, 1e-6);
  EXPECT_NEAR(chance_of_variance_ratio(19, 2, 2), 0.05, 1e-9);
  EXPECT_NEAR(chance_of_variance_ratio(3.708265, 3, 10), 0.05, 1e-6);
  EXPECT_NEAR(chance_of_variance_ratio(30.81652, 2, 3), 0.01, 1e-6);
  EXPECT_NEAR(chance_of_variance_ratio(1.352, 120, 120), 0.05, 5e-4);
}

TEST(VarianceRatio, IsCertainlyAboveNothingAndNeverAboveEverything) {
  EXPECT_EQ(chance_of_variance_ratio(0, 2, 3), 1);
  EXPECT_EQ(chance_of_variance_ratio(1e300, 2, 3), 0);
  EXPECT_NEAR(chance_of_variance_ratio(1, 7, 7), 0.5, 1e-12);
}

}  // namespace
}  // namespace fogcomp
