#include "fit/left_out_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/fit/made_rows.hpp"

namespace fogcomp::fit {
namespace {

std::size_t rows_of(const Part& part) {
  std::size_t rows = 0;
  for (const recording::RowRange& range : part) rows += range.size();
  return rows;
}

TEST(LeftOutParts, CutEveryRun) {
  series::Rows rows = fog::test::soak_ramp_soak(100, 100);
  rows.run_starts = {0, 120};
  const std::vector<Part> thirds = cut_runs(rows, 3);
  ASSERT_EQ(thirds.size(), 3U);
  EXPECT_EQ(thirds[0][0].first, 0U);
  EXPECT_EQ(thirds[0][0].end, 40U);
  EXPECT_EQ(thirds[0][1].first, 120U);
  EXPECT_EQ(thirds[2][1].end, 300U);
  EXPECT_EQ(rows_of(thirds[0]) + rows_of(thirds[1]) + rows_of(thirds[2]), 300U);
}

TEST(LeftOutParts, TellHeatingFromCoolingAndLeaveSoaks) {
  const auto up_and_down = [](double row) { return 20 + std::max(0.0, 50 - std::abs(row - 50)); };
  const std::vector<Part> directions = directions_of(fog::test::made_rows(200, up_and_down));
  ASSERT_EQ(directions.size(), 2U);
  EXPECT_EQ(rows_of(directions[0]), 50U);
  EXPECT_EQ(directions[0].front().first, 1U);
  EXPECT_EQ(rows_of(directions[1]), 50U);
  EXPECT_EQ(directions[1].back().end, 101U);
}

TEST(LeftOutParts, DivideRowsByTemperature) {
  const auto ramp_and_back = [](double row) { return 20 + std::abs(row - 150); };
  const std::vector<Part> thirds = temperatures_of(fog::test::made_rows(300, ramp_and_back));
  ASSERT_EQ(thirds.size(), 3U);
  for (const Part& third : thirds) EXPECT_EQ(rows_of(third), 100U);
  for (const recording::RowRange& row : thirds[0]) {
    EXPECT_NEAR(static_cast<double>(row.first), 150, 51);
  }
  EXPECT_EQ(thirds[2].front().first, 0U);
  EXPECT_EQ(thirds[2].back().end, 300U);
}

}  // namespace
}  // namespace fogcomp::fit
