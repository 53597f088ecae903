// Additions that train a network: under the sanitizers that takes minutes, and
// DropsANetworkToWhichTheEffectLeavesNothing does it there.
#include "fit/add_effect.hpp"

#include <gtest/gtest.h>

#include "fit/effect_change.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace {

using namespace fog::test;
using fogcomp::fit::Addition;
using fogcomp::model::Model;

TEST(AddNetwork, TrainsTheOneThatIsThereAgainOfTheSameSize) {
  Model model = incomplete("bias,bias_temperature:order=3");
  model.network = paper_like_model().network;
  const fogcomp::fit::EffectChange change =
      fogcomp::fit::change_effect(model.terms, "temperature_rate");
  Model heated = truth();
  heated.terms.push_back(written_term("heat = abs(dTdt)"));
  heated.terms.back().coefficients_dph = {1};  // the regressor is small, as its range is +-32
  const Addition result = add_effect(model, change, runs_of(heated, {1}), {});
  EXPECT_TRUE(result.accepted);
  ASSERT_EQ(result.model.network.hidden.biases.size(), 3);
  EXPECT_NE(result.model.network.hidden.biases[0], model.network.hidden.biases[0]);
}

// Not an effect of the catalogue.
Model with_kink(double coefficient_dph) {
  Model gyro = truth();
  gyro.terms.push_back(written_term("kink = max(T-20,0)"));
  gyro.terms.back().coefficients_dph = {coefficient_dph};
  return gyro;
}

TEST(AddNetwork, IsJudgedAgainstTheEffectsAlone) {
  const Model model = incomplete(kComplete);
  const auto network = fogcomp::fit::change_effects(model.terms, {"network:hidden=3"});
  const Model kinked = with_kink(200);
  const Addition right = add_effect(model, network, runs_of(kinked, {1}), {});
  EXPECT_TRUE(right.accepted) << right.reason;
  EXPECT_EQ(right.model.network.hidden.biases.size(), 3);
  EXPECT_EQ(right.names(), std::vector<std::string>{"network"});
  EXPECT_EQ(right.model.history.back().action, "add network:hidden=3");
  EXPECT_LT(right.model.history.back().rms_after_dph, right.model.history.back().rms_before_dph);
  const Addition needless = add_effect(model, network, runs_of(truth(), {1}), {});
  EXPECT_FALSE(needless.accepted);
  EXPECT_FALSE(needless.model.network.present());
}

// In the holdout, the learnt effect has the opposite sign.
TEST(AddNetwork, IsJudgedOnTheHoldout) {
  const Model model = incomplete(kComplete);
  const auto network = fogcomp::fit::change_effects(model.terms, {"network:hidden=3"});
  const Model kinked = with_kink(200);
  const Model other = with_kink(-200);
  const auto judged_by = [&](const fogcomp::runs::Run& holdout) {
    fogcomp::runs::Runs runs = runs_of(kinked, {1});
    runs.holdouts = {holdout};
    return add_effect(model, network, runs, {});
  };
  EXPECT_TRUE(judged_by(run_of(kinked, 2)).accepted);
  EXPECT_FALSE(judged_by(run_of(other, 2)).accepted);
}

}  // namespace
