#include "batch/summary.hpp"

#include <gtest/gtest.h>

namespace fogcomp::batch {
namespace {

TEST(Summary, SpreadOfAFigure_IsOverTheGyrosThatHaveIt) {
  std::vector<GyroResult> results;
  for (const double value : {4.0, 1.0, 3.0, 2.0}) results.push_back({"G", "", "", {{"f", value}}});
  results.push_back({"without", "", "", {}});
  const Summary::Spread spread = summarise(results, {}, {}).spread_of("f");
  EXPECT_EQ(spread.gyros, 4U);
  EXPECT_EQ(spread.min, 1);
  EXPECT_EQ(spread.median, 3);
  EXPECT_EQ(spread.max, 4);
}

}  // namespace
}  // namespace fogcomp::batch
