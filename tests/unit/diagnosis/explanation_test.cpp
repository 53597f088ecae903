#include "diagnosis/explanation.hpp"

#include <gtest/gtest.h>

namespace {

using fogcomp::ColumnRange;

// One effect explains all but `left` of a residual; smooth functions see that too.
bool is_enough(double left, bool event, double chi_square = 10000) {
  constexpr Eigen::Index kRows = 50;
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(kRows, 2);
  fogcomp::ExplainedSpace space(
      axes * Eigen::Vector2d(std::sqrt((1 - left) * chi_square), std::sqrt(left * chi_square)));
  const ColumnRange effect = space.add(axes.col(0));
  const ColumnRange structure = space.add(axes.col(1));
  space.finish();
  fogcomp::Hypothesis hypothesis;
  hypothesis.parts = {{0, 0}};
  hypothesis.gain = space.gain({effect});
  hypothesis.led_by_event = event;
  return fogcomp::explain(space, {{effect}}, structure, {hypothesis}).enough;
}

TEST(Explanation, ByAnEffectMayLeaveATenthAsNoFormulaIsExact) {
  EXPECT_TRUE(is_enough(0.08, false));
  EXPECT_FALSE(is_enough(0.12, false));
}

TEST(Explanation, ByAnEventMayLeaveAFewHundredthsAsAStepIsExact) {
  EXPECT_TRUE(is_enough(0.02, true));
  EXPECT_FALSE(is_enough(0.05, true));
}

// Three effects explain all but `left`.
bool are_enough(double left, bool pliable) {
  constexpr double kChiSquare = 10000;
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(50, 4);
  const double each = std::sqrt((1 - left) / 3 * kChiSquare);
  fogcomp::ExplainedSpace space(axes *
                                Eigen::Vector4d(each, each, each, std::sqrt(left * kChiSquare)));
  fogcomp::Library library;
  fogcomp::Hypothesis hypothesis;
  for (std::size_t i = 0; i < 3; ++i) {
    library.push_back({space.add(axes.col(static_cast<Eigen::Index>(i)))});
    hypothesis.parts.push_back({i, 0});
  }
  const ColumnRange structure = space.add(axes.col(3));
  space.finish();
  hypothesis.gain = space.gain(fogcomp::ranges_of(library, hypothesis));
  hypothesis.pliable = pliable;
  return fogcomp::explain(space, library, structure, {hypothesis}).enough;
}

TEST(Explanation, ByThreePliableOnesMayLeaveLessAsTheyImitateNearlyEverything) {
  EXPECT_TRUE(are_enough(0.02, true));
  EXPECT_FALSE(are_enough(0.04, true));
  EXPECT_TRUE(are_enough(0.04, false));
  EXPECT_FALSE(are_enough(0.06, false));
}

TEST(Explanation, MayLeaveWhatNoiseIs) {
  EXPECT_TRUE(is_enough(0.05, true, 80));    // chi^2 of 4 in one direction
  EXPECT_FALSE(is_enough(0.05, true, 800));  // of 40
}

}  // namespace
