#include "noise/quiet_rows.hpp"

#include <gtest/gtest.h>

#include "unit/fit/made_rows.hpp"

namespace {

using fog::test::made_rows;
using fog::test::soak_ramp_soak;

// The first and last row of each stretch: the residual of a row is its number.
std::vector<std::pair<double, double>> quiet(const fogcomp::Rows& rows) {
  const Eigen::VectorXd number =
      Eigen::VectorXd::LinSpaced(rows.size(), 0, static_cast<double>(rows.size()) - 1);
  std::vector<std::pair<double, double>> ends;
  for (const Eigen::VectorXd& stretch : fogcomp::quiet_stretches(rows, number)) {
    ends.emplace_back(stretch[0], stretch[stretch.size() - 1]);
    EXPECT_EQ(stretch.size(), static_cast<Eigen::Index>(ends.back().second - ends.back().first) + 1)
        << "rows are left out in between";
  }
  return ends;
}
using Ends = std::vector<std::pair<double, double>>;

TEST(QuietRows, AreTheSoaksAndNothingOfTheRamp) {
  EXPECT_EQ(quiet(soak_ramp_soak(100, 60)), (Ends{{0, 99}, {160, 259}}));
}

TEST(QuietRows, EndWhereARecordingDoesAndAtAGap) {
  fogcomp::Rows rows = soak_ramp_soak(100, 60);
  rows.run_starts = {0, 40};
  for (std::size_t i = 200; i < rows.time_s.size(); ++i) rows.time_s[i] += 30;
  EXPECT_EQ(quiet(rows), (Ends{{0, 39}, {40, 99}, {160, 199}, {200, 259}}));
}

TEST(QuietRows, EndWhereAnotherInputJumpsAndNotWhereItDrifts) {
  fogcomp::Rows rows = soak_ramp_soak(100, 60);
  for (std::size_t i = 0; i < rows.signals.size(); ++i) {
    rows.signals[i].block.input_rate = i < 50 ? -15 : 15;  // the axis is turned over
    rows.signals[i].block.extension[0] = 20 + 0.01 * static_cast<double>(i);
  }
  EXPECT_EQ(quiet(rows), (Ends{{0, 49}, {50, 99}, {160, 259}}));
}

TEST(QuietRows, AreNoneWhereTooFewStandStill) {
  EXPECT_TRUE(quiet(soak_ramp_soak(31, 60)).empty());
  EXPECT_TRUE(quiet(made_rows(0, [](double) { return 20; })).empty());
  EXPECT_TRUE(quiet(made_rows(1, [](double) { return 20; })).empty());
  EXPECT_TRUE(quiet(made_rows(500, [](double row) { return 0.1 * row; })).empty());
}

TEST(QuietRows, AreAllOfARecordingAtRest) {
  EXPECT_EQ(quiet(made_rows(500, [](double) { return 20; })), (Ends{{0, 499}}));
}

}  // namespace
