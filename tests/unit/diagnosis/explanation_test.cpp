#include "diagnosis/explanation.hpp"

#include <gtest/gtest.h>

namespace fogcomp::diagnosis {
namespace {

enum class Kind { plain, event, free_shape };

// `effects`, all equal, explain all but `left` of a residual; smooth functions explain the rest.
bool is_enough(std::size_t effects, Kind kind, double left, double chi_square = 10000) {
  const auto last = static_cast<Eigen::Index>(effects);
  const Eigen::MatrixXd axes = Eigen::MatrixXd::Identity(50, last + 1);
  std::vector<Eigen::MatrixXf> columns;
  for (const auto axis : axes.colwise()) columns.emplace_back(axis.cast<float>());
  Eigen::VectorXd projection = Eigen::VectorXd::Constant(
      last + 1, std::sqrt((1 - left) / static_cast<double>(effects) * chi_square));
  projection[last] = std::sqrt(left * chi_square);
  fit::ExplainedSpace space(axes * projection);
  RegressorBasis regressors;
  Hypothesis hypothesis;
  for (std::size_t i = 0; i < effects; ++i) {
    regressors.push_back({space.add(columns[i])});
    hypothesis.parts.push_back({i, 0});
  }
  const series::ColumnRange structure = space.add(columns.back());
  space.finish();
  hypothesis.chi2_drop = space.chi2_drop(ranges_of(regressors, hypothesis));
  hypothesis.led_by_event = kind == Kind::event;
  hypothesis.free_shape = kind == Kind::free_shape;
  return explain(space, regressors, structure, {hypothesis}).enough;
}

// The largest fraction that may be left, for a chi^2 far above the noise.
double max_left(std::size_t effects, Kind kind) {
  double enough = 0;
  double too_much = 1;
  for (int i = 0; i < 20; ++i) {
    const double left = (enough + too_much) / 2;
    (is_enough(effects, kind, left, 1e8) ? enough : too_much) = left;
  }
  return enough;
}

// No formula is exact, so an effect may leave a little; an effect that is not there leaves most.
TEST(Explanation, ByAnEffectMayLeaveAFewPercentAndNotAThird) {
  EXPECT_GT(max_left(1, Kind::plain), 0.03);
  EXPECT_LT(max_left(1, Kind::plain), 0.3);
}

// The more flexible the set, the less it may leave, because it can imitate other effects.
TEST(Explanation, MayLeaveTheLessTheMoreIsBentToGiveIt) {
  EXPECT_LT(max_left(2, Kind::plain), max_left(1, Kind::plain));
  EXPECT_LE(max_left(3, Kind::plain), max_left(2, Kind::plain));
  EXPECT_LT(max_left(3, Kind::free_shape), max_left(3, Kind::plain));
  EXPECT_GT(max_left(3, Kind::free_shape), 0);
}

// A step is exact; something similar differs from it by a few hundredths.
TEST(Explanation, ByAnEventMayLeaveLessThanByAnEffect) {
  EXPECT_LT(max_left(1, Kind::event), max_left(1, Kind::plain));
  EXPECT_GT(max_left(1, Kind::event), 0);
}

TEST(Explanation, MayLeaveWhatNoiseIs) {
  EXPECT_TRUE(is_enough(1, Kind::event, 0.05, 80));    // chi^2 of 4 in one direction
  EXPECT_FALSE(is_enough(1, Kind::event, 0.05, 800));  // of 40
}

}  // namespace
}  // namespace fogcomp::diagnosis
