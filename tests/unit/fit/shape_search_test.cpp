#include "fit/shape_search.hpp"

#include <gtest/gtest.h>

#include "fit/descent.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::recording_of;
using fog::test::truth;

// A gyro with a lag whose time constant is searched, beside effects that have no shape.
class ShapeSearch : public testing::Test {
 protected:
  ShapeSearch() {
    gyro_.terms = model::parse_effects("bias,bias_temperature:order=2,thermal_lag:tau=900");
    gyro_.terms[0].coefficients_dph = {0.5};
    gyro_.terms[1].coefficients_dph = {0.1, -0.2};
    gyro_.terms[2].coefficients_dph = {0.3};
    recording_ = recording_of(gyro_, {0.002, 0, 300}, 1);
    series_.add(series::make_blocks(recording_));
    noise::NoiseModel white;
    white.white_variance = 0.002 * 0.002;
    whitening_.emplace(white, series_.rows(), series_.rows().weights);
  }
  // The lag searched for, from so many seconds.
  WhitenedProblem problem(double tau_s) {
    std::vector<model::EffectTerm> terms =
        model::parse_effects("bias,bias_temperature:order=2,thermal_lag:tau=?");
    terms[2].parameters[0].value = tau_s;
    return problem(terms);
  }
  WhitenedProblem problem(const std::vector<model::EffectTerm>& terms) {
    return {regressors_, *whitening_, terms, Eigen::MatrixXd(series_.rows().size(), 0)};
  }
  static std::vector<model::ShapeParameter> shapes(const WhitenedProblem& problem) {
    return model::shape_parameters(problem.terms());
  }

 private:
  model::Model gyro_ = truth();
  recording::Recording recording_;
  series::SignalSeries series_{gyro_};
  KnownRegressors regressors_{series_};
  std::optional<noise::Whitening> whitening_;
};

TEST_F(ShapeSearch, CostIsThatOfAllColumnsTogether) {
  const WhitenedProblem at = problem(2000);
  EXPECT_NEAR(at.solution().cost, solve_linear(at.matrix(), at.measured()).residual.squaredNorm(),
              1e-9 * at.solution().cost);
}

// A bound between the start and the optimum, 900 s.
TEST_F(ShapeSearch, ADescentEndsAtABoundThatIsInItsWay) {
  std::vector<model::EffectTerm> terms =
      model::parse_effects("bias,bias_temperature:order=2,thermal_lag:tau=?[1200,5000]");
  terms[2].parameters[0].value = 3000;
  WhitenedProblem bounded = problem(terms);
  Descent descent(bounded, shapes(bounded), 1e-9);
  descent.finish();
  EXPECT_NEAR(descent.problem().value(shapes(bounded)[0]), 1200, 0.1);
}

TEST_F(ShapeSearch, ADescentIsAbandonedWhereItsStepsPromiseTooLittle) {
  const WhitenedProblem best = problem(900);
  const WhitenedProblem far = problem(3000);
  Descent descent(far, shapes(far), 1e-9);
  const double left = descent.cost();
  descent.step();
  EXPECT_LT(descent.cost(), left);
  descent.abandon_if_above(best.solution().cost);
  EXPECT_FALSE(descent.ended());
  descent.finish();
  EXPECT_NEAR(descent.problem().value(shapes(far)[0]), 900, 20);
  Descent at_best(problem(905), shapes(best), 0);
  at_best.step();
  at_best.abandon_if_above(0.5 * at_best.cost());
  EXPECT_TRUE(at_best.ended());
}

// An expression beside it that has no shape, and overflows.
TEST_F(ShapeSearch, EndsWhereWhatDoesNotMoveIsNoNumber) {
  std::vector<model::EffectTerm> terms = problem(800).terms();
  terms.push_back(model::expression_term("x = exp(exp(T))"));
  WhitenedProblem broken = problem(terms);
  const std::vector<model::ShapeParameter> moving = shapes(broken);
  EXPECT_TRUE(std::isinf(broken.solution().cost));
  EXPECT_FALSE(broken.step(moving, broken.solution()).change.allFinite());
  EXPECT_FALSE(search_shapes(broken, moving, {true})[0]);
  EXPECT_EQ(broken.value(moving[0]), 800);
}

TEST_F(ShapeSearch, CostsOfAGridAreThoseOfItsValues) {
  const WhitenedProblem start = problem(2000);
  const std::vector<double> values{300, 600, 900, 1500, 2500, 4000};
  const std::vector<double> costs = start.costs(shapes(start)[0], values, {});
  for (std::size_t i = 0; i < values.size(); ++i) {
    WhitenedProblem moved = start;
    moved.set(shapes(start), {values[i]});
    EXPECT_NEAR(costs[i], moved.solution().cost, 1e-9 * moved.solution().cost);
    EXPECT_NEAR(costs[i], problem(values[i]).solution().cost, 1e-9 * moved.solution().cost);
  }
}

// The columns of the other ripple stay.
TEST_F(ShapeSearch, CostsOfAGridAreThoseOfItsValuesBesideWhatDoesNotMove) {
  std::vector<model::EffectTerm> terms = model::parse_effects("bias,polarization_ripple:period2=?");
  terms[1].parameters[0].value = 11;
  terms[1].parameters[1].value = 29;
  const WhitenedProblem start = problem(terms);
  ASSERT_EQ(shapes(start).size(), 2U);
  const std::vector<double> values{5, 8, 17, 23};
  for (const model::ShapeParameter& period : shapes(start)) {
    const std::vector<double> costs = start.costs(period, values, {});
    for (std::size_t i = 0; i < values.size(); ++i) {
      WhitenedProblem moved = start;
      moved.set({period}, {values[i]});
      EXPECT_NEAR(costs[i], moved.solution().cost, 1e-9 * moved.solution().cost);
    }
  }
}

TEST_F(ShapeSearch, StepPromisesWhatItBringsNearTheBestPlace) {
  WhitenedProblem near = problem(850);
  const double before = near.solution().cost;
  const model::ShapeParameter tau = shapes(near)[0];
  const WhitenedProblem::Step step = near.step({tau}, near.solution());
  near.set({tau}, {tau.from_unit(tau.to_unit(850) + step.change[0])});
  EXPECT_LT(near.solution().cost, before);
  EXPECT_NEAR(near.solution().cost, step.cost, 0.1 * (before - step.cost));
}

TEST_F(ShapeSearch, FindsTheTimeConstantAndSaysWhetherADipTookItElsewhere) {
  for (const double from : {60.0, 800.0, 10000.0}) {
    WhitenedProblem searched = problem(from);
    const std::vector<bool> elsewhere = search_shapes(searched, shapes(searched), {true});
    EXPECT_NEAR(searched.value(shapes(searched)[0]), 900, 20) << from;
    // The found value has no better neighbour.
    WhitenedProblem again = searched;
    EXPECT_FALSE(search_shapes(again, shapes(again), {true})[0]) << from;
    EXPECT_NEAR(again.value(shapes(again)[0]), searched.value(shapes(searched)[0]), 0.1);
  }
}

TEST_F(ShapeSearch, CostToFirstOrderIsThatOfTheBestPlaceWhereItIsNearOrInAGrid) {
  const WhitenedProblem best = problem(900);
  const WhitenedProblem near = problem(850);
  const WhitenedProblem far = problem(10000);
  const double lowest = best.solution().cost;
  EXPECT_NEAR(first_order_cost(near, shapes(near), {false}), lowest,
              0.1 * (near.solution().cost - lowest));
  const double without_grid = first_order_cost(far, shapes(far), {false});
  const double with_grid = first_order_cost(far, shapes(far), {true});
  EXPECT_LT(with_grid - lowest, 0.1 * (without_grid - lowest));
  EXPECT_GE(with_grid, lowest);
  EXPECT_EQ(first_order_cost(best, {}, {}),
            solve_linear(best.matrix(), best.measured()).residual.squaredNorm());
}

// Before the first parameter is found too: with many rows that alone is longer than one likes to
// wait for a sign of life.
TEST_F(ShapeSearch, TellsOftenHowFarItIsAndNeverGoesBack) {
  WhitenedProblem searched = problem(10000);
  std::vector<double> told;
  search_shapes(searched, shapes(searched), {true}, true,
                [&](double done) { told.push_back(done); });
  EXPECT_GE(told.size(), 5U);
  EXPECT_GT(told.front(), 0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
}

TEST_F(ShapeSearch, StaysInItsDipWhereNoRangeIsAsked) {
  WhitenedProblem near = problem(800);
  EXPECT_FALSE(search_shapes(near, shapes(near), {false})[0]);
  EXPECT_NEAR(near.value(shapes(near)[0]), 900, 20);
}

}  // namespace
}  // namespace fogcomp::fit
