#include "fit/left_out_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/effect_list.hpp"
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
  const std::vector<FarPart> far = far_parts(rows, {});
  const std::vector<Part> thirds{far[0].part, far[1].part, far[2].part};
  EXPECT_EQ(thirds[0][0].first, 0U);
  EXPECT_EQ(thirds[0][0].end, 40U);
  EXPECT_EQ(thirds[0][1].first, 120U);
  EXPECT_EQ(thirds[2][1].end, 300U);
  EXPECT_EQ(rows_of(thirds[0]) + rows_of(thirds[1]) + rows_of(thirds[2]), 300U);
}

TEST(LeftOutParts, TellHeatingFromCoolingAndLeaveSoaks) {
  const auto up_and_down = [](double row) { return 20 + std::max(0.0, 50 - std::abs(row - 50)); };
  const std::vector<FarPart> far = far_parts(fog::test::made_rows(200, up_and_down), {});
  const std::vector<Part> directions{far[3].part, far[4].part};
  EXPECT_EQ(far[4].name, "cooling");
  EXPECT_EQ(rows_of(directions[0]), 50U);
  EXPECT_EQ(directions[0].front().first, 1U);
  EXPECT_EQ(rows_of(directions[1]), 50U);
  EXPECT_EQ(directions[1].back().end, 101U);
}

TEST(LeftOutParts, DivideRowsByTemperature) {
  const auto ramp_and_back = [](double row) { return 20 + std::abs(row - 150); };
  const std::vector<FarPart> far = far_parts(fog::test::made_rows(300, ramp_and_back), {});
  const std::vector<Part> thirds{far[5].part, far[6].part, far[7].part};
  EXPECT_EQ(far[5].name, "the coldest third");
  for (const Part& third : thirds) EXPECT_EQ(rows_of(third), 100U);
  ASSERT_EQ(thirds[0].size(), 1U);
  EXPECT_NEAR(static_cast<double>(thirds[0][0].first), 100, 1);
  EXPECT_EQ(thirds[2].front().first, 0U);
  EXPECT_EQ(thirds[2].back().end, 300U);
}

TEST(LeftOutParts, InputOfItsOwn_DividesTheRowsByIt) {
  series::Rows rows = fog::test::made_rows(300, [](double) { return 20; });
  for (std::size_t i = 0; i < rows.inputs.size(); ++i) {
    rows.inputs[i].input_rate = 100.0 * static_cast<double>(i % 3);
  }
  const std::vector<FarPart> without = far_parts(rows, model::parse_effects("thermal_lag"));
  const std::vector<FarPart> far = far_parts(rows, model::parse_effects("scale_factor"));
  ASSERT_EQ(far.size(), without.size() + 3);
  EXPECT_EQ(far.back().name, "the highest third of the input rate");
  EXPECT_EQ(far.back().part.size(), 100U);
  EXPECT_EQ(far.back().part.front().first, 2U);
}

TEST(LeftOutParts, TwoRecordings_EachLeftOutOnce) {
  series::Rows rows = fog::test::soak_ramp_soak(100, 100);
  rows.run_starts = {0, 120};
  const FarPart last = far_parts(rows, {}).back();
  EXPECT_EQ(last.name, "run 2");
  EXPECT_EQ(last.part[0].first, 120U);
}

TEST(LeftOutParts, StretchesInTurn_HoldEveryRowOnceAndBeginEachRunWithAnother) {
  series::Rows rows = fog::test::soak_ramp_soak(500, 500);
  rows.run_starts = {0, 600};
  const Folds folds = stretches_in_turn(rows);
  std::vector<int> counts(1500, 0);
  for (const Part& part : folds.parts) {
    for (const recording::RowRange& range : part) {
      for (std::size_t row = range.first; row < range.end; ++row) ++counts[row];
    }
  }
  EXPECT_EQ(counts, std::vector<int>(1500, 1));
  EXPECT_EQ(folds.parts[0][0].first, 0U);
  EXPECT_TRUE(std::any_of(folds.parts[1].begin(), folds.parts[1].end(),
                          [](const recording::RowRange& range) { return range.first == 600; }));
}

}  // namespace
}  // namespace fogcomp::fit
