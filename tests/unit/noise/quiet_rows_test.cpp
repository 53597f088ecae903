#include "noise/quiet_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "unit/fit/made_rows.hpp"

namespace fogcomp::noise {
namespace {

using fog::test::made_rows;
using fog::test::soak_ramp_soak;

// The first and last row of each stretch: the residual of a row is its number.
std::vector<std::pair<double, double>> quiet(const series::Rows& rows) {
  const Eigen::VectorXd number =
      Eigen::VectorXd::LinSpaced(rows.size(), 0, static_cast<double>(rows.size()) - 1);
  std::vector<std::pair<double, double>> ends;
  for (const Eigen::VectorXd& stretch : quiet_stretches(rows, number)) {
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
  series::Rows rows = soak_ramp_soak(100, 60);
  rows.run_starts = {0, 40};
  for (std::size_t i = 200; i < rows.time_s.size(); ++i) rows.time_s[i] += 30;
  EXPECT_EQ(quiet(rows), (Ends{{0, 39}, {40, 99}, {160, 199}, {200, 259}}));
}

TEST(QuietRows, EndWhereAnotherInputJumpsAndNotWhereItDrifts) {
  series::Rows rows = soak_ramp_soak(100, 60);
  for (std::size_t i = 0; i < rows.signals.size(); ++i) {
    rows.inputs[i].input_rate = i < 50 ? -15 : 15;  // the axis is turned over
    rows.inputs[i].extension[0] = 20 + 0.01 * static_cast<double>(i);
  }
  EXPECT_EQ(quiet(rows), (Ends{{0, 49}, {50, 99}, {160, 259}}));
}

// A fifth of an input's range may come from drift of its source; three tenths are a switch.
TEST(QuietRows, EndWhereAnInputJumpsByMoreThanAQuarterOfItsRange) {
  const auto rows_with = [](double jump) {
    series::Rows rows = made_rows(200, [](double) { return 20; });
    for (std::size_t i = 0; i < 200; ++i) {
      // From 0 to 1 in all: slowly, but for the jump.
      rows.inputs[i].input_rate = (1 - jump) * static_cast<double>(i) / 199 + (i < 100 ? 0 : jump);
    }
    return rows;
  };
  EXPECT_EQ(quiet(rows_with(0.2)), (Ends{{0, 199}}));
  EXPECT_EQ(quiet(rows_with(0.3)), (Ends{{0, 99}, {100, 199}}));
}

// A logged quantity of which only the noise changes; then it is switched as well.
TEST(QuietRows, DoNotEndAtTheNoiseOfAnInput) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  series::Rows rows = made_rows(200, [](double) { return 20; });
  for (auto& inputs : rows.inputs) inputs.extension[0] = 100 + noise(random);
  EXPECT_EQ(quiet(rows), (Ends{{0, 199}}));
  for (std::size_t i = 80; i < 200; ++i) rows.inputs[i].extension[0] += 20;
  EXPECT_EQ(quiet(rows), (Ends{{0, 79}, {80, 199}}));
}

// 30 deg/s within 90 s, beside rows at rest.
TEST(QuietRows, AreNotThoseInWhichARateTableSweeps) {
  series::Rows rows = made_rows(200, [](double) { return 20; });
  for (std::size_t i = 100; i < 200; ++i) {
    rows.inputs[i].input_rate = 108000 * std::sin(static_cast<double>(i - 99) * 2 * M_PI / 9);
  }
  EXPECT_EQ(quiet(rows), (Ends{{0, 99}}));
}

TEST(QuietRows, MayHaveTheNoiseOfAReferenceAtRest) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(10, 5);  // deg/h
  series::Rows rows = made_rows(200, [](double) { return 20; });
  for (auto& inputs : rows.inputs) inputs.input_rate = noise(random);
  EXPECT_EQ(quiet(rows), (Ends{{0, 199}}));
}

// Two soaks with a slow temperature drift of so many degC/min, and a ramp of 1 degC/min.
series::Rows creeping(double creep, double ramp) {
  return made_rows(260, [=](double row) {
    const double in_ramp = std::clamp(row - 99, 0.0, 60.0);
    return 20 + (creep * (row - in_ramp) + ramp * in_ramp) / 6;
  });
}

TEST(QuietRows, MayCreepByATwentiethOfTheRamps) {
  const Ends soaks{{0, 99}, {160, 259}};
  EXPECT_EQ(quiet(creeping(0.04, 1)), soaks);
  EXPECT_EQ(quiet(creeping(0.07, 1)), (Ends{}));
  EXPECT_EQ(quiet(creeping(0.07, 2)), soaks);
}

TEST(QuietRows, MayCreepByAFiftiethOfADegreeAMinuteWithoutARamp) {
  EXPECT_EQ(quiet(creeping(0.015, 0.015)), (Ends{{0, 259}}));
  EXPECT_EQ(quiet(creeping(0.03, 0.03)), (Ends{}));
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
}  // namespace fogcomp::noise
