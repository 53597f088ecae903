#include "diagnosis/explanation.hpp"

#include <gtest/gtest.h>

namespace fogcomp::diagnosis {
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
  fit::ExplainedSpace space(axes * along);
  Library library;
  Hypothesis hypothesis;
  for (std::size_t i = 0; i < effects; ++i) {
    library.push_back({space.add(axes.col(static_cast<Eigen::Index>(i)))});
    hypothesis.parts.push_back({i, 0});
  }
  const series::ColumnRange structure = space.add(axes.col(last));
  space.finish();
  hypothesis.gain = space.gain(ranges_of(library, hypothesis));
  hypothesis.led_by_event = kind == Kind::event;
  hypothesis.pliable = kind == Kind::pliable;
  return explain(space, library, structure, {hypothesis}).enough;
}

// The largest share that may be left, of a chi^2 that makes noise nothing beside it.
double most_left(std::size_t effects, Kind kind) {
  double enough = 0;
  double too_much = 1;
  for (int i = 0; i < 20; ++i) {
    const double left = (enough + too_much) / 2;
    (is_enough(effects, kind, left, 1e8) ? enough : too_much) = left;
  }
  return enough;
}

// No formula is exactly what a gyro does, so that an effect may leave something; an effect that is
// not there leaves most.
TEST(Explanation, ByAnEffectMayLeaveAFewPercentAndNotAThird) {
  EXPECT_GT(most_left(1, Kind::plain), 0.03);
  EXPECT_LT(most_left(1, Kind::plain), 0.3);
}

// The more that can be bent to imitate what is none of it, the less it may leave.
TEST(Explanation, MayLeaveTheLessTheMoreIsBentToGiveIt) {
  EXPECT_LT(most_left(2, Kind::plain), most_left(1, Kind::plain));
  EXPECT_LE(most_left(3, Kind::plain), most_left(2, Kind::plain));
  EXPECT_LT(most_left(3, Kind::pliable), most_left(3, Kind::plain));
  EXPECT_GT(most_left(3, Kind::pliable), 0);
}

// A step is exact; what only resembles one is in all but a few hundredths like it.
TEST(Explanation, ByAnEventMayLeaveLessThanByAnEffect) {
  EXPECT_LT(most_left(1, Kind::event), most_left(1, Kind::plain));
  EXPECT_GT(most_left(1, Kind::event), 0);
}

TEST(Explanation, MayLeaveWhatNoiseIs) {
  EXPECT_TRUE(is_enough(1, Kind::event, 0.05, 80));    // chi^2 of 4 in one direction
  EXPECT_FALSE(is_enough(1, Kind::event, 0.05, 800));  // of 40
}

}  // namespace
}  // namespace fogcomp::diagnosis
