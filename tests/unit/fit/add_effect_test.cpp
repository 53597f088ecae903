#include "fit/add_effect.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fit/effect_change.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/recording_with_steps.hpp"
#include "unit/fit/simulated_addition.hpp"

namespace {

using namespace fog::test;
using fogcomp::fit::Addition;
using fogcomp::model::Model;

TEST(AddEffect, AcceptsATrueEffect) {
  const Addition result = add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1});
  EXPECT_TRUE(result.accepted) << result.reason;
  EXPECT_FALSE(result.model.history.back().forced);
}

// The lag was searched for: another order must not set it back to 0.
TEST(AddEffect, SearchesAgainForWhatWasSearchedFor) {
  std::vector<fogcomp::model::EffectTerm> terms =
      fogcomp::model::parse_effects("bias,scale_factor_temperature:lag=?");
  terms[1].parameters[2].value = -120;
  const auto changed = fogcomp::fit::change_effect(terms, "scale_factor_temperature:order=2");
  EXPECT_EQ(changed.terms[1].parameters[0].value, 2);
  EXPECT_EQ(changed.terms[1].parameters[2].value, -120);
  EXPECT_TRUE(changed.terms[1].parameters[2].identified);
  for (const std::string effect :
       {"scale_factor_temperature:lag=60", "scale_factor_temperature: lag = 60"}) {
    const auto given = fogcomp::fit::change_effect(terms, effect);
    EXPECT_EQ(given.terms[1].parameters[2].value, 60);
    EXPECT_FALSE(given.terms[1].parameters[2].identified);
  }
}

// A transition is searched for within the recorded temperatures, also once more.
TEST(AddEffect, SearchesAgainWithinTheSameBounds) {
  const std::vector<fogcomp::model::EffectTerm> terms =
      fogcomp::model::parse_effects("bias,glass_transition");
  for (const std::string effect : {"glass_transition:lag=?", "glass_transition:lag=180"}) {
    const auto changed = fogcomp::fit::change_effect(terms, effect);
    EXPECT_FALSE(changed.terms[1].parameters[0].bounds.are_given()) << effect;
  }
  const auto given = fogcomp::fit::change_effect(terms, "glass_transition:tg=?[-10,20]");
  EXPECT_EQ(given.terms[1].parameters[0].bounds.min, -10);
}

// The verdict is the same; the model is fitted in its own rows.
TEST(AddEffect, JudgesWhateverTheRowsOfTheModel) {
  const fogcomp::runs::Runs runs = runs_of(truth(), {1});
  const auto in_rows = [&](double row_s) {
    Model given = incomplete("bias,bias_temperature:order=3");
    given.average_s = row_s;
    return fogcomp::fit::add_effect(
        given, fogcomp::fit::change_effect(given.terms, "temperature_rate"), runs, {});
  };
  const Addition usual = in_rows(10);
  const Addition longer = in_rows(60);
  EXPECT_EQ(longer.row_s, 10);
  EXPECT_EQ(longer.reason, usual.reason);
  ASSERT_EQ(longer.model.terms.size(), usual.model.terms.size());
  for (std::size_t i = 0; i < usual.model.terms.size(); ++i) {
    EXPECT_NEAR(longer.model.terms[i].coefficients_dph[0].value,
                usual.model.terms[i].coefficients_dph[0].value,
                2 * usual.model.terms[i].coefficients_dph[0].sigma);
  }
  EXPECT_EQ(longer.fitted_after_dph, usual.model.residual_rms_dph);
  EXPECT_EQ(longer.model.average_s, 60);
  EXPECT_EQ(longer.model.history.back().rms_after_dph, longer.model.residual_rms_dph);
  EXPECT_NEAR(longer.model.residual_rms_dph, longer.runs.at(0).rms_after_dph, 1e-9);
  EXPECT_LT(longer.model.residual_rms_dph, 0.6 * usual.model.residual_rms_dph);  // less noise
}

TEST(AddEffect, JudgesSeveralTogetherAndEachAloneAndBesideTheOthers) {
  Model bent = truth();
  bent.terms[1].coefficients_dph[2].value *= 2;
  const Model given = incomplete("bias,bias_temperature:order=2");
  const Addition result = fogcomp::fit::add_effect(
      given,
      fogcomp::fit::change_effects(given.terms, {"temperature_rate", "bias_temperature:order=3"}),
      runs_of(bent, {1}), {});
  EXPECT_TRUE(result.accepted) << result.reason;
  EXPECT_EQ(result.changed, (std::vector<std::size_t>{2, 1}));
  ASSERT_EQ(result.parts.size(), 2U);
  for (const Addition::Part& part : result.parts) {
    ASSERT_TRUE(part.alone && part.beside) << part.effect;
    EXPECT_TRUE(part.beside->score.improves()) << part.effect;
  }
}

TEST(AddEffect, RefusesASetOfWhichOneBringsNothing) {
  const Model given = incomplete("bias,bias_temperature:order=3");
  const Addition result = fogcomp::fit::add_effect(
      given,
      fogcomp::fit::change_effects(given.terms,
                                   {"temperature_rate", "thermal_hysteresis:radius=5"}),
      runs_of(truth(), {1}), {});
  EXPECT_TRUE(result.out_of_sample->score.improves());
  EXPECT_FALSE(result.accepted);
  EXPECT_NE(result.reason.find("thermal_hysteresis"), std::string::npos) << result.reason;
}

TEST(EffectChange, TakesNoEffectTwice) {
  const std::vector<fogcomp::model::EffectTerm> terms = fogcomp::model::parse_effects("bias");
  EXPECT_THROW(fogcomp::fit::change_effects(terms, {"shupe", "shupe:tau=300"}),
               fogcomp::InputError);
}

// Formulas may be a little wrong, and so may this one: but whether it is, is the question.
TEST(AddEffect, JudgesHowAnEffectBends) {
  const std::string effects = "bias,bias_temperature:order=2,temperature_rate";
  Model gyro = truth();
  gyro.terms[1].parameters[0].value = 4;
  gyro.terms[1].coefficients_dph = {{-1, 1e-4}, {-0.7, 1e-4}, {0, 1e-4}, {0.03, 1e-4}};
  const Addition bent = add(effects, "bias_temperature:order=4", gyro, {1, 2});
  EXPECT_TRUE(bent.accepted) << bent.reason;
  gyro.terms[1].coefficients_dph[3].value = 0;
  const Addition straight = add(effects, "bias_temperature:order=4", gyro, {1, 2});
  EXPECT_FALSE(straight.accepted) << straight.reason;
}

TEST(AddEffect, RefusesAUselessEffect) {
  const Addition result = add(kComplete, "thermal_hysteresis:radius=5", truth(), {1});
  EXPECT_FALSE(result.accepted);
  EXPECT_TRUE(result.model.history.back().forced);
}

// A bound is a value like another: an ageing that these hours show as a line.
TEST(AddEffect, AnEffectAtTheBoundOfItsShape_IsJudgedLikeAnyOther) {
  Model drifting = truth();
  drifting.terms.push_back(fog::test::natural_term("aging", {2e6}, {30}));
  const Addition result = add(kComplete, "aging", drifting, {1});
  EXPECT_TRUE(result.accepted) << result.reason;
}

constexpr double kStep_s = 15000;

fogcomp::recording::Recording recording_with_step(std::uint64_t seed, double size_dph) {
  fogcomp::recording::Recording recording = noisy_recording(seed);
  add_step(recording, kStep_s, size_dph);
  return recording;
}

Addition add_cut(const fogcomp::runs::Runs& runs) {
  const Model given = incomplete(kComplete);
  const std::vector<fogcomp::recording::Cut> cuts{{"", kStep_s}};
  return fogcomp::fit::add_effect(given, fogcomp::fit::change_cuts(given.terms, cuts),
                                  runs.with(cuts), {});
}

// Stretches of its own run judge it, also where there is a holdout, of which it is no part.
TEST(AddEffect, CutAtAStepThatStandsOut_AcceptedOnStretches) {
  fogcomp::runs::Runs runs = runs_of(truth(), {});
  runs.training.push_back(fogcomp::runs::run_of(recording_with_step(1, 5 * kWhiteDph), {10}));
  const auto holdout = fogcomp::runs::run_of(noisy_recording(2), {10});
  for (const auto& holdouts : {std::vector<fogcomp::runs::Run>{}, {holdout}}) {
    runs.holdouts = holdouts;
    const Addition result = add_cut(runs);
    EXPECT_TRUE(result.accepted) << result.reason;
    ASSERT_TRUE(result.out_of_sample);
    EXPECT_TRUE(result.out_of_sample->within_runs);
    EXPECT_LT(result.out_of_sample->rms_after_dph, 0.8 * result.out_of_sample->rms_before_dph);
    EXPECT_LT(result.runs[0].rms_after_dph, 0.8 * result.runs[0].rms_before_dph);
    EXPECT_EQ(result.names(), std::vector<std::string>{"cut"});
    EXPECT_EQ(result.model.history.back().action, "add --cut 15000");
  }
}

TEST(AddEffect, CutWithoutAStep_Refused) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    fogcomp::runs::Runs runs = runs_of(truth(), {});
    runs.training.push_back(fogcomp::runs::run_of(noisy_recording(seed), {10}));
    const Addition result = add_cut(runs);
    EXPECT_FALSE(result.accepted) << result.reason;
  }
}

TEST(EffectChange, AnEvent_RefusedWithTheOptionThatDoesIt) {
  try {
    fogcomp::fit::change_effect(fogcomp::model::parse_effects("bias"), "bias_step");
    FAIL() << "no error";
  } catch (const fogcomp::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--cut [RUN:]T"), std::string::npos) << error.what();
  }
}

TEST(EffectChange, TakesOtherBoundsOfAParameterThatIsIdentified) {
  const std::vector<fogcomp::model::EffectTerm> terms =
      fogcomp::model::parse_effects("bias,polarization_ripple");
  const auto change = fogcomp::fit::change_effect(terms, "polarization_ripple:period=?[2,10]");
  const fogcomp::model::EffectTerm& changed = change.terms[change.changed.at(0)];
  EXPECT_EQ(changed.parameters[0].bounds.max, 10);
  EXPECT_LE(changed.parameters[0].value, 10);  // 13 was outside
  EXPECT_THROW(fogcomp::fit::change_effect(terms, "polarization_ripple:period=?"),
               fogcomp::InputError);
}

TEST(AddEffect, IsJudgedOnHoldoutsWhereThereAreSome) {
  const Addition result = add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1},
                              {run_of(truth(), 101)});
  EXPECT_TRUE(result.accepted) << result.reason;
  ASSERT_EQ(result.runs.size(), 2U);
  EXPECT_FALSE(result.runs[0].holdout);
  EXPECT_TRUE(result.runs[1].holdout);
  EXPECT_LT(result.runs[1].rms_after_dph, result.runs[1].rms_before_dph);
  ASSERT_TRUE(result.model.history.back().holdout.has_value());
  EXPECT_NEAR(result.model.history.back().holdout->rms_after_dph, result.runs[1].rms_after_dph,
              1e-12);
}

// A holdout of another gyro: the effect of the training run is wrong there.
TEST(AddEffect, RefusesWhatHoldsOnlyForTheTrainingRun) {
  Model other = truth();
  other.terms[2].coefficients_dph = {-0.44};
  const Addition result =
      add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1}, {run_of(other, 2)});
  EXPECT_FALSE(result.accepted);
  EXPECT_LT(result.out_of_sample->score.gain, 0);
}

TEST(AddEffect, LeavesEachOfThreeRunsOutOnce) {
  const Addition result =
      add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1, 2, 3});
  EXPECT_TRUE(result.accepted);
  EXPECT_EQ(result.out_of_sample->how, "on 3 runs, each left out once");
}

// Without the one run with vibration, nothing is known of the effect: its first rows tell of the
// others.
TEST(AddEffect, OneRunAloneShowsTheEffect_IsJudgedByItself) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  fogcomp::runs::Runs runs = runs_of(truth(), {});
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    fogcomp::recording::Recording recording = recording_of(truth(), kAdditionNoise, seed);
    for (std::size_t i = 0; i < recording.rows(); ++i) {
      const double shaken = seed == 3 && i / 100 % 2 == 1 ? 2 : 0;
      recording[fog::Input::vibration].push_back(std::abs(shaken + 0.01 * normal(random)));
      recording.rate_dph[i] +=
          0.05 * recording[fog::Input::vibration][i] * recording[fog::Input::vibration][i];
    }
    runs.training.push_back(fogcomp::runs::run_of(recording, {10}));
  }
  const Model model = incomplete(kComplete);
  const Addition result =
      add_effect(model, fogcomp::fit::change_effect(model.terms, "vibration"), runs, {});
  EXPECT_TRUE(result.accepted) << result.reason;
}

// From 30 degC up: it does not show what a polynomial does in the cold.
fogcomp::runs::Run warm_run(std::uint64_t seed) {
  fogcomp::recording::Recording recording = recording_of(truth(), kAdditionNoise, seed);
  const auto hot = std::find_if(recording.temperature_degc.begin(),
                                recording.temperature_degc.end(), [](double t) { return t > 30; });
  const auto first = hot - recording.temperature_degc.begin();
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph}) {
    column->erase(column->begin(), column->begin() + first);
  }
  return fogcomp::runs::run_of(recording, {10});
}

TEST(AddEffect, OthersDoNotDetermineTheModelForARun_StillAccepted) {
  fogcomp::runs::Runs runs = runs_of(truth(), {1});
  runs.training.push_back(warm_run(2));
  runs.training.push_back(warm_run(3));
  const Model model = incomplete("bias,bias_temperature:order=3");
  const Addition result =
      add_effect(model, fogcomp::fit::change_effect(model.terms, "temperature_rate"), runs, {});
  EXPECT_TRUE(result.accepted) << result.reason;
}

// The whole warm-up is in the first of the stretches left out in turn: the others say nothing about
// it, nor about another effect.
TEST(AddEffect, StretchesSayNothingOfAnotherEffect_StillAccepted) {
  Model warming = truth();
  warming.terms[2].coefficients_dph = {0.3};
  warming.terms.push_back(fog::test::natural_term("warm_up", {300}, {0.5}));
  const Addition result =
      add("bias,bias_temperature:order=3,warm_up:tau=300", "temperature_rate", warming, {1});
  EXPECT_TRUE(result.accepted) << result.reason;
}

// It is over within the first of the stretches, without which nothing is known of it.
TEST(AddEffect, WarmUpOfOneRun_Accepted) {
  Model warming = truth();
  warming.terms.push_back(fog::test::natural_term("warm_up", {600}, {0.06}));
  const Addition result = add(kComplete, "warm_up", warming, {1});
  EXPECT_TRUE(result.accepted) << result.reason;
}

// The start of one run is left out while that of the other is not.
TEST(AddEffect, JudgesAWarmUpOfTwoRuns) {
  Model warming = truth();
  warming.terms.push_back(fog::test::natural_term("warm_up", {900}, {0.2}));
  const Addition result = add(kComplete, "warm_up", warming, {1, 2});
  EXPECT_TRUE(result.accepted) << result.reason;
  EXPECT_LT(result.out_of_sample->rms_after_dph, result.out_of_sample->rms_before_dph)
      << result.reason;
}

// A minute of a ramp.
fogcomp::recording::Recording minute() {
  fogcomp::recording::Recording recording = recording_of(truth(), kAdditionNoise, 1);
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph})
    *column = {column->begin() + 400, column->begin() + 464};
  for (std::size_t row = 0; row < 64; ++row) recording.time_s[row] = static_cast<double>(row);
  recording.period_s = 1;
  return recording;
}

TEST(AddEffect, RunEndsBeforeTheDerivativeSettles_SaysSo) {
  fogcomp::runs::Runs runs;
  runs.training.push_back(fogcomp::runs::run_of(minute(), {1}));
  Model model = incomplete("bias");
  model.average_s = 1;
  try {
    add_effect(model, fogcomp::fit::change_effect(model.terms, "bias_temperature:order=1"), runs,
               {});
    FAIL() << "it is judged by no row";
  } catch (const fogcomp::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("too few rows"), std::string::npos) << error.what();
  }
}

TEST(AddEffect, DropsANetworkToWhichTheEffectLeavesNothing) {
  Model model = incomplete("bias,bias_temperature:order=3");
  model.network = paper_like_model().network;
  const fogcomp::fit::EffectChange change =
      fogcomp::fit::change_effect(model.terms, "temperature_rate");
  const Addition result = add_effect(model, change, runs_of(truth(), {1}), {});
  EXPECT_TRUE(result.accepted);
  EXPECT_FALSE(result.model.network.present()) << "gain " << result.fit.network_judged->score.gain;
}

// `definition` added to a model of all but `real`, of 0.1 deg/h, that the gyro has.
Addition add_expression(const std::string& real, const std::string& definition) {
  Model gyro = truth();
  gyro.terms.push_back(fogcomp::model::expression_term(real));
  gyro.terms.back().coefficients_dph = {0.1};
  const Model model = incomplete(kComplete);
  return add_effect(model, fogcomp::fit::change_expression(model.terms, definition),
                    runs_of(gyro, {1}), {});
}

// In the middle of its range the kink is where these runs never are.
TEST(AddEffect, FindsAnExpressionThatIsZeroWhereTheSearchBegins) {
  const Addition found = add_expression("kink = max(T-20,0)", "kink = max(T-?from[-20,220],0)");
  EXPECT_TRUE(found.accepted) << found.reason;
  EXPECT_NEAR(found.model.terms[found.changed.at(0)].parameters[0].value, 20, 5);
}

TEST(AddEffect, JudgesAnExpressionLikeAnEffect) {
  const std::string definition = "late = lag(dTdt^2, ?tau[60,6000])";
  const Addition right = add_expression("late = lag(dTdt^2, 900)", definition);
  EXPECT_TRUE(right.accepted) << right.reason;
  EXPECT_EQ(right.model.history.back().action, "add " + definition);
  const fogcomp::model::EffectTerm& term = right.model.terms[right.changed.at(0)];
  EXPECT_NEAR(term.parameters[0].value, 900, 4 * term.parameters[0].sigma);
  const auto [value, sigma] = fogcomp::model::natural_coefficient(term, 0);
  EXPECT_LT(sigma, 0.015);
  EXPECT_NEAR(value, 0.1, 4 * sigma);
}

TEST(EffectChange, MayBeANetworkByItself) {
  const auto terms = fogcomp::model::parse_effects("bias");
  EXPECT_EQ(fogcomp::fit::change_effects(terms, {"network"}).network_hidden, 4);
  EXPECT_EQ(fogcomp::fit::change_effects(terms, {"network:hidden=9"}).network_hidden, 9);
  for (const char* wrong : {"network:hidden=0", "network:hidden=33", "network:hidden=2.5",
                            "network:hidden=", "network:neurons=3"}) {
    EXPECT_THROW(fogcomp::fit::change_effects(terms, {wrong}), fogcomp::InputError) << wrong;
  }
  EXPECT_THROW(fogcomp::fit::change_effects(terms, {"aging", "network"}), fogcomp::InputError);
}

TEST(EffectChange, RaisesWhatIsThere) {
  const auto terms =
      fogcomp::model::parse_effects("bias,bias_temperature:order=3,thermal_hysteresis");
  const auto order = fogcomp::fit::change_effect(terms, "bias_temperature:order=4");
  EXPECT_EQ(order.changed.at(0), 1U);
  ASSERT_EQ(order.terms.size(), 3U);
  EXPECT_EQ(order.terms[1].shape(), std::vector<double>{4});

  auto identified = terms;
  identified[2].parameters[0].value = 7.5;  // by an earlier fit
  const auto radius = fogcomp::fit::change_effect(identified, "thermal_hysteresis:radius2=15");
  EXPECT_EQ(radius.terms[2].shape(), (std::vector<double>{7.5, 15}));
  EXPECT_TRUE(radius.terms[2].parameters[0].identified);
  EXPECT_FALSE(radius.terms[2].parameters[1].identified);
  EXPECT_EQ(fogcomp::fit::change_effect(terms, "thermal_lag:tau=300").terms.size(), 4U);
}

TEST(EffectChange, GrowsAnEffectThatIsThereAlready) {
  const auto terms =
      fogcomp::model::parse_effects("bias,bias_temperature:order=3,thermal_hysteresis");
  const auto higher = fogcomp::fit::change_effect(terms, "bias_temperature");
  EXPECT_EQ(higher.changed.at(0), 1U);
  EXPECT_EQ(higher.terms[1].parameters[0].value, 4);
  const auto second = fogcomp::fit::change_effect(terms, "thermal_hysteresis");
  EXPECT_TRUE(second.terms[2].parameters[1].identified);
  EXPECT_GT(second.terms[2].parameters[1].value, 0);
}

TEST(EffectChange, RefusesAnExpressionWhoseNameIsTaken) {
  auto terms = fogcomp::model::parse_effects("bias");
  terms = fogcomp::fit::change_expression(terms, "own = T*dTdt").terms;
  ASSERT_EQ(terms.size(), 2U);
  for (const char* const definition : {"own = T", "bias = T", "thermal_lag = T", "own", ""}) {
    EXPECT_THROW(fogcomp::fit::change_expression(terms, definition), fogcomp::InputError)
        << definition;
  }
}

TEST(EffectChange, RefusesWhatChangesNothing) {
  const auto terms = fogcomp::model::parse_effects("bias,bias_temperature:order=3");
  for (const char* const effect :
       {"bias", "bias_temperature:order=3", "", "thermal_lag,warm_up", "no_such_effect"}) {
    EXPECT_THROW(fogcomp::fit::change_effect(terms, effect), fogcomp::InputError) << effect;
  }
}

}  // namespace
