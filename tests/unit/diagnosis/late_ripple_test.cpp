#include "diagnosis/late_ripple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "model/effect_list.hpp"
#include "model/shape_parameter.hpp"
#include "support/text.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kNoiseDph = 0.024;
constexpr Eigen::Index kHour = 360;  // rows

// Rows of the sample gyro's programme and, in units of the noise, an expression as residual.
class LateRipple : public testing::Test {
 protected:
  LateRipple() {
    series_.add(series::make_blocks(fog::test::recording_of(model_, fog::test::kQuietNoise, 1)));
  }
  Eigen::VectorXd residual(const std::string& expression) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Eigen::VectorXd left = series_.regressors(model::expression_term("x = " + expression)).col(0);
    for (double& value : left) value = 0.05 / kNoiseDph * value + normal(random);
    // A model and slow structure take out most of what is constant over an hour.
    for (Eigen::Index row = 0; row + kHour <= left.size(); row += kHour) {
      left.segment(row, kHour).array() -= left.segment(row, kHour).mean();
    }
    return left;
  }
  std::vector<std::string> all_found(const std::string& hidden,
                                     const std::vector<model::EffectTerm>& terms) {
    return find_late_ripples(series_, terms, residual(hidden));
  }
  // Parameters of the fit that starts from the first expression found.
  model::EffectTerm found(const std::string& hidden) {
    const std::vector<std::string> expressions = all_found(hidden, {});
    return expressions.empty() ? model::EffectTerm{} : model::expression_term(expressions.front());
  }
  static bool is_within(const model::EffectTerm& term, std::size_t which, double value) {
    const model::ShapeParameter parameter = model::shape_parameters({term}).at(which);
    return parameter.min < value && value < parameter.max;
  }

 private:
  model::Model model_ = fog::test::truth();
  series::SignalSeries series_{model_, series::Phase::zero};
};

TEST_F(LateRipple, IsFoundWithBoundsAroundItsLagAndPeriod) {
  for (const auto& [lag_s, period_degc] : {std::pair{600., 9.}, {150., 14.}, {1500., 11.}}) {
    const model::EffectTerm term = found(format("sin(6.2832*lag(T,%g)/%g+1)", lag_s, period_degc));
    ASSERT_EQ(term.name, "T_late_ripple");
    EXPECT_TRUE(is_within(term, 0, lag_s)) << lag_s;
    EXPECT_TRUE(is_within(term, 1, period_degc)) << period_degc;
  }
}

TEST_F(LateRipple, MayBeFurtherAwayAndHasANameThatIsFree) {
  const std::string hidden = "sin(6.2832*lag(T,600)/9+1)";
  const model::EffectTerm first = found(hidden);
  const std::vector<std::string> next = all_found(hidden, {first});
  ASSERT_EQ(next.size(), 2U);
  const model::EffectTerm wide = model::expression_term(next[1]);
  EXPECT_EQ(wide.name, "T_late_ripple_2");
  EXPECT_TRUE(is_within(wide, 0, 100));
  EXPECT_FALSE(is_within(first, 0, 100));
}

TEST_F(LateRipple, IsNotSeenInCyclesOfTime) {
  EXPECT_EQ(found("sin(t/300)+sin(t/220)+sin(t/410)").name, "");
}

}  // namespace
}  // namespace fogcomp::diagnosis
