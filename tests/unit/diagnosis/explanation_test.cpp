#include "diagnosis/explanation.hpp"

#include <gtest/gtest.h>

namespace {

enum class Kind { plain, event, pliable };

// Of `effects`, all alike, that explain all but `left` of a residual; smooth functions see that
// too.
bool is_enough(std::size_t effects, Kind kind, double left, double chi_square = 10000) {
  const auto last = static_cast<Eigen::Index>(effects);
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(50, last + 1);
  Eigen::VectorXd along = Eigen::VectorXd::Constant(
      last + 1, std::sqrt((1 - left) / static_cast<double>(effects) * chi_square));
  along[last] = std::sqrt(left * chi_square);
  fogcomp::ExplainedSpace space(axes * along);
  fogcomp::Library library;
  fogcomp::Hypothesis hypothesis;
  for (std::size_t i = 0; i < effects; ++i) {
    library.push_back({space.add(axes.col(static_cast<Eigen::Index>(i)))});
    hypothesis.parts.push_back({i, 0});
  }
  const fogcomp::ColumnRange structure = space.add(axes.col(last));
  space.finish();
  hypothesis.gain = space.gain(fogcomp::ranges_of(library, hypothesis));
  hypothesis.led_by_event = kind == Kind::event;
  hypothesis.pliable = kind == Kind::pliable;
  return fogcomp::explain(space, library, structure, {hypothesis}).enough;
}

TEST(Explanation, ByAnEffectMayLeaveATenthAsNoFormulaIsExact) {
  EXPECT_TRUE(is_enough(1, Kind::plain, 0.08));
  EXPECT_FALSE(is_enough(1, Kind::plain, 0.12));
}

TEST(Explanation, ByAnEventMayLeaveAFewHundredthsAsAStepIsExact) {
  EXPECT_TRUE(is_enough(1, Kind::event, 0.02));
  EXPECT_FALSE(is_enough(1, Kind::event, 0.05));
}

TEST(Explanation, ByThreePliableOnesMayLeaveLessAsTheyImitateNearlyEverything) {
  EXPECT_TRUE(is_enough(3, Kind::pliable, 0.02));
  EXPECT_FALSE(is_enough(3, Kind::pliable, 0.04));
  EXPECT_TRUE(is_enough(3, Kind::plain, 0.04));
  EXPECT_FALSE(is_enough(3, Kind::plain, 0.06));
}

TEST(Explanation, MayLeaveWhatNoiseIs) {
  EXPECT_TRUE(is_enough(1, Kind::event, 0.05, 80));    // chi^2 of 4 in one direction
  EXPECT_FALSE(is_enough(1, Kind::event, 0.05, 800));  // of 40
}

}  // namespace
