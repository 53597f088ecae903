#include "diagnosis/ladder.hpp"

#include <gtest/gtest.h>

#include "model/effect_list.hpp"
#include "support/typical_effects.hpp"
#include "unit/diagnosis/looped.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::diagnosis {
namespace {

using Names = std::vector<std::string>;

Ladder::Step step(const Names& effects, const std::string& expression = "") {
  Ladder::Step one;
  one.addition.request = {effects, expression};
  return one;
}

TEST(Ladder, ListsWhatItAddedOnceEach) {
  Ladder ladder;
  EXPECT_TRUE(ladder.added().empty());
  ladder.steps = {step({"thermal_hysteresis"}), step({"shupe", "bias_temperature:order=4"}),
                  step({}, "square = dTdt^2"), step({"thermal_hysteresis:radius2=20"})};
  EXPECT_EQ(ladder.added(), (Names{"thermal_hysteresis", "shupe", "bias_temperature", "square"}));
  EXPECT_TRUE(ladder.described().empty());
  ladder.steps[2].describes = true;
  EXPECT_EQ(ladder.added(), (Names{"thermal_hysteresis", "shupe", "bias_temperature"}));
  EXPECT_EQ(ladder.described(), Names{"square"});
}

// A rate term is missing.
TEST(Ladder, AddsNoMoreThanItMayAndSaysWhatAStepBrought) {
  model::Model model = fog::test::truth();
  const recording::Recording recording =
      fog::test::thinned(fog::test::recording_of(model, fog::test::kQuietNoise, 1), 3);
  model.terms = model::parse_effects("bias,bias_temperature:order=3");
  const Ladder ladder = fog::test::looped(model, recording, 1);
  ASSERT_EQ(ladder.steps.size(), 1U);
  EXPECT_TRUE(ladder.is_cut_off);
  const Ladder::Step& step = ladder.steps[0];
  EXPECT_EQ(ladder.added(), Names{effect_to_add(ladder.first)});
  EXPECT_FALSE(step.describes);
  EXPECT_EQ(step.addition.fitted_before_dph, ladder.model.history.back().rms_before_dph);
  EXPECT_EQ(step.addition.fitted_after_dph, ladder.model.history.back().rms_after_dph);
  EXPECT_LT(step.addition.fitted_after_dph, 0.5 * step.addition.fitted_before_dph);
  ASSERT_EQ(ladder.model.terms.size(), 3U);
  EXPECT_EQ(ladder.model.terms.back().name, effect_to_add(ladder.first));
  EXPECT_EQ(ladder.model.history.back().action, "add " + effect_to_add(ladder.first));
}

// A ripple beside a rate term that is fifty times as large: together they leave nothing. The rate
// term has a board's delay here, so that a lag is as true.
TEST(Ladder, AddsWhatIsNamedHoweverSmallBesideWhatWasAdded) {
  model::Model model = fog::test::truth();
  model.terms[2].coefficients_dph = {0.6};
  model.terms.push_back(fog::test::natural_term("polarization_ripple", {9}, {0.01, 0}));
  const recording::Recording recording = fog::test::recording_of(model, fog::test::kQuietNoise, 1);
  model.terms = model::parse_effects("bias,bias_temperature:order=3");
  const Ladder ladder = fog::test::looped(model, recording, 3);
  ASSERT_EQ(ladder.steps.size(), 2U);
  EXPECT_TRUE(ladder.added()[0] == "temperature_rate" || ladder.added()[0] == "thermal_lag");
  EXPECT_EQ(ladder.added()[1], "polarization_ripple");
  EXPECT_FALSE(ladder.is_cut_off);
  EXPECT_FALSE(ladder.steps[0].addition.holdouts);
}

// The catalogue's ageing has one speed; what its formula leaves out is freed next.
TEST(Ladder, AddsAnAgeingThatIsFasterWhenWarm) {
  model::Model model = fog::test::truth();
  model.terms.push_back(fog::test::natural_term("aging", {20000, 1.5}, {0.3}));
  const recording::Recording recording = fog::test::recording_of(model, fog::test::kQuietNoise, 1);
  model.terms = model::parse_effects("bias,bias_temperature:order=3,temperature_rate");
  const Ladder ladder = fog::test::looped(model, recording, 1);
  ASSERT_EQ(ladder.steps.size(), 2U);
  EXPECT_EQ(ladder.steps[0].addition.request.effects, Names{"aging"});
  EXPECT_EQ(ladder.steps[1].addition.request.effects, Names{"aging:q10=?"});
  const model::EffectTerm& ageing = ladder.model.terms.back();
  EXPECT_NEAR(ageing.parameters[1].value, 1.5, 4 * ageing.parameters[1].sigma);
}

}  // namespace
}  // namespace fogcomp::diagnosis
