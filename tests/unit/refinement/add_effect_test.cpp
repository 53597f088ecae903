#include "refinement/add_effect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/effect_list.hpp"
#include "model/catalogue.hpp"
#include "refinement/effect_change.hpp"
#include "support/input_error.hpp"
#include "support/typical_effects.hpp"
#include "unit/identification/simulated_gyro.hpp"

namespace {

using fog::test::truth;
using fogcomp::Addition;
using fogcomp::Model;

constexpr fog::test::RowNoise kNoise{0.024, 0.006, 300};

Model model_of(const std::string& effects) {
  Model model = truth();
  model.terms = fogcomp::parse_effects(effects);
  model.history.clear();
  return model;
}

fogcomp::RunInBlocks run_of(const Model& real, std::uint64_t seed) {
  return fogcomp::run_in_blocks(fog::test::recording_of(real, kNoise, seed), 10);
}

fogcomp::TrainingRuns runs_of(const Model& real, const std::vector<std::uint64_t>& seeds) {
  fogcomp::TrainingRuns training;
  for (const std::uint64_t seed : seeds) training.runs.push_back(run_of(real, seed));
  if (!training.runs.empty()) training.noise_floor_dph = training.runs[0].noise_floor_dph;
  training.noise_dph_rthz = 0.075;
  return training;
}

Addition add(const std::string& model, const std::string& effect, const Model& real,
             const std::vector<std::uint64_t>& seeds,
             const std::vector<fogcomp::RunInBlocks>& holdouts = {}) {
  const Model given = model_of(model);
  return add_effect(given, fogcomp::change_effect(given.terms, effect), runs_of(real, seeds),
                    holdouts, {});
}

const std::string kComplete = "bias,bias_temperature:order=3,temperature_rate";

// An effect that stands out by about five standard deviations is accepted in most of 20 recordings,
// one ten times as large in all.
TEST(AddEffect, AcceptsATrueEffect) {
  for (const double size : {1.0, 10.0}) {
    Model real = truth();
    real.terms[2].coefficients_dph = {size * 0.06};
    int accepted = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const Addition result =
          add("bias,bias_temperature:order=3", "temperature_rate", real, {seed});
      if (result.accepted) ++accepted;
      if (seed == 1) {
        std::printf("%g times: %.1f sigma, %s\n", size,
                    result.model.terms[2].coefficients_dph[0] / result.model.terms[2].sigma_dph[0],
                    result.reason.c_str());
      }
    }
    std::printf("%d of 20 accepted\n", accepted);
    EXPECT_GE(accepted, size > 1 ? 20 : 15);
  }
}

TEST(AddEffect, RefusesAUselessEffect) {
  int accepted = 0;
  int tried = 0;
  for (const char* const effect :
       {"thermal_hysteresis:radius=5", "thermal_lag", "warm_up", "polarization_ripple",
        "temperature_rate_product", "bias_temperature:order=4"}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Addition result = add(kComplete, effect, truth(), {seed});
      ++tried;
      if (result.accepted) ++accepted;
      if (result.accepted) std::printf("%s: %s\n", effect, result.reason.c_str());
      EXPECT_EQ(result.model.history.back().forced, !result.accepted);
    }
  }
  std::printf("%d of %d useless effects accepted\n", accepted, tried);
  EXPECT_LE(accepted, 2);  // kLeastGain lets about one in 100 pass
}

TEST(AddEffect, IsJudgedOnHoldoutsWhereThereAreSome) {
  int useful = 0;
  int useless = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<fogcomp::RunInBlocks> holdouts{run_of(truth(), 100 + seed)};
    const Addition good =
        add("bias,bias_temperature:order=3", "temperature_rate", truth(), {seed}, holdouts);
    if (good.accepted) ++useful;
    if (add(kComplete, "thermal_hysteresis", truth(), {seed}, holdouts).accepted) ++useless;
    ASSERT_EQ(good.runs.size(), 2U);
    EXPECT_FALSE(good.runs[0].holdout);
    EXPECT_TRUE(good.runs[1].holdout);
    EXPECT_LT(good.runs[1].rms_after_dph, good.runs[1].rms_before_dph);
    ASSERT_TRUE(good.model.history.back().holdout.has_value());
    EXPECT_NEAR(good.model.history.back().holdout->rms_after_dph, good.runs[1].rms_after_dph,
                1e-12);
  }
  EXPECT_EQ(useful, 10);
  EXPECT_LE(useless, 1);
}

// A holdout of another gyro: what the training run shows is wrong there.
TEST(AddEffect, RefusesWhatHoldsOnlyForTheTrainingRun) {
  Model other = truth();
  other.terms[2].coefficients_dph = {-0.44};
  const Addition result =
      add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1}, {run_of(other, 2)});
  EXPECT_FALSE(result.accepted);
  EXPECT_LT(result.out_of_sample.gain, 0);
}

TEST(AddEffect, LeavesEachOfThreeRunsOutOnce) {
  const Addition result =
      add("bias,bias_temperature:order=3", "temperature_rate", truth(), {1, 2, 3});
  EXPECT_TRUE(result.accepted);
  EXPECT_EQ(result.out_of_sample.how, "on 3 runs, each left out once");
}

// Without the one run that was shaken, the others know nothing of vibration: leaving runs out would
// judge an extrapolation.
TEST(AddEffect, LeavesStretchesOutWhereOneRunAloneShowsTheEffect) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  fogcomp::TrainingRuns training = runs_of(truth(), {});
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    fogcomp::Recording recording = fog::test::recording_of(truth(), kNoise, seed);
    for (std::size_t i = 0; i < recording.rows(); ++i) {
      const double shaken = seed == 3 && i / 100 % 2 == 1 ? 2 : 0;
      recording.vibration_grms.push_back(std::abs(shaken + 0.01 * normal(random)));
      recording.rate_dph[i] += 0.05 * recording.vibration_grms[i] * recording.vibration_grms[i];
    }
    training.runs.push_back(fogcomp::run_in_blocks(recording, 10));
  }
  const Model model = model_of(kComplete);
  const Addition result =
      add_effect(model, change_effect(model.terms, "vibration"), training, {}, {});
  EXPECT_TRUE(result.accepted) << result.reason;
  EXPECT_NE(result.out_of_sample.how.find("stretches"), std::string::npos);
}

// Half of a run with the same phases as the other confirms a true effect.
TEST(AddEffect, TellsWhatTheHalvesOfTheRunsSay) {
  Model real = truth();
  real.terms[2].coefficients_dph = {0.6};
  const Addition result = add("bias,bias_temperature:order=3", "temperature_rate", real, {1});
  ASSERT_EQ(result.halves.size(), 2U);
  for (const fogcomp::HalfTest& half : result.halves) {
    EXPECT_TRUE(half.determined);
    EXPECT_LT(half.rms_after_dph, half.rms_before_dph) << half.identified_on;
  }
}

TEST(AddEffect, RetrainsANetworkOfTheSameSize) {
  Model model = model_of("bias,bias_temperature:order=3");
  model.network = fog::test::paper_like_model().network;
  const fogcomp::EffectChange change = fogcomp::change_effect(model.terms, "temperature_rate");
  Model heated = truth();
  heated.terms.push_back(fog::test::written_term("heat = abs(dTdt)"));
  heated.terms.back().coefficients_dph = {1};  // the regressor is small, as its range is +-32
  const Addition result = add_effect(model, change, runs_of(heated, {1}), {}, {});
  EXPECT_TRUE(result.accepted);
  ASSERT_EQ(result.model.network.hidden.biases.size(), 3);
  EXPECT_NE(result.model.network.hidden.biases[0], model.network.hidden.biases[0]);
}

TEST(AddEffect, DropsANetworkToWhichTheEffectLeavesNothing) {
  Model model = model_of("bias,bias_temperature:order=3");
  model.network = fog::test::paper_like_model().network;
  const fogcomp::EffectChange change = fogcomp::change_effect(model.terms, "temperature_rate");
  const Addition result = add_effect(model, change, runs_of(truth(), {1}), {}, {});
  EXPECT_TRUE(result.accepted);
  EXPECT_FALSE(result.model.network.present()) << "gain " << result.fit.network_judged->gain;
}

TEST(AddEffect, JudgesAnExpressionLikeAnEffect) {
  Model real = truth();
  fogcomp::EffectTerm late = fogcomp::expression_term("late = lag(dTdt^2, 900)");
  late.coefficients_dph = {0.1};
  real.terms.push_back(late);
  const Model model = model_of(kComplete);
  const std::string definition = "late = lag(dTdt^2, ?tau[60,6000])";
  const auto add_to = [&](const Model& gyro, std::uint64_t seed) {
    return add_effect(model, fogcomp::change_expression(model.terms, definition),
                      runs_of(gyro, {seed}), {}, {});
  };
  const Addition right = add_to(real, 1);
  EXPECT_TRUE(right.accepted) << right.reason;
  EXPECT_EQ(right.model.history.back().action, "add " + definition);
  const fogcomp::EffectTerm& term = right.model.terms[right.changed];
  EXPECT_NEAR(term.parameters[0], 900, 4 * term.parameter_sigma[0]);
  const double sigma =
      fogcomp::in_natural_unit(term.sigma_dph[0], fogcomp::info_of(term).coefficients[0]);
  EXPECT_LT(sigma, 0.01);
  EXPECT_NEAR(natural_coefficient(term, 0), 0.1, 4 * sigma);
  int useless = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    useless += add_to(truth(), seed).accepted ? 1 : 0;
  EXPECT_LE(useless, 1);  // kLeastGain lets about one in 100 pass
}

TEST(EffectChange, RaisesWhatIsThere) {
  const auto terms = fogcomp::parse_effects("bias,bias_temperature:order=3,thermal_hysteresis");
  const auto order = fogcomp::change_effect(terms, "bias_temperature:order=4");
  EXPECT_EQ(order.changed, 1U);
  ASSERT_EQ(order.terms.size(), 3U);
  EXPECT_EQ(order.terms[1].parameters, std::vector<double>{4});

  auto identified = terms;
  identified[2].parameters[0] = 7.5;  // by an earlier fit
  const auto radius = fogcomp::change_effect(identified, "thermal_hysteresis:radius2=15");
  EXPECT_EQ(radius.terms[2].parameters, (std::vector<double>{7.5, 15}));
  EXPECT_TRUE(radius.terms[2].identified[0]);
  EXPECT_FALSE(radius.terms[2].identified[1]);
  EXPECT_EQ(fogcomp::change_effect(terms, "thermal_lag:tau=300").terms.size(), 4U);
}

TEST(EffectChange, GrowsAnEffectThatIsThereAlready) {
  const auto terms = fogcomp::parse_effects("bias,bias_temperature:order=3,thermal_hysteresis");
  const auto higher = fogcomp::change_effect(terms, "bias_temperature");
  EXPECT_EQ(higher.changed, 1U);
  EXPECT_EQ(higher.terms[1].parameters[0], 4);
  const auto second = fogcomp::change_effect(terms, "thermal_hysteresis");
  EXPECT_TRUE(second.terms[2].identified[1]);
  EXPECT_GT(second.terms[2].parameters[1], 0);
}

TEST(EffectChange, RefusesAnExpressionWhoseNameIsTaken) {
  auto terms = fogcomp::parse_effects("bias");
  terms = fogcomp::change_expression(terms, "own = T*dTdt").terms;
  ASSERT_EQ(terms.size(), 2U);
  for (const char* const definition : {"own = T", "bias = T", "thermal_lag = T", "own", ""}) {
    EXPECT_THROW(fogcomp::change_expression(terms, definition), fogcomp::InputError) << definition;
  }
}

TEST(EffectChange, RefusesWhatChangesNothing) {
  const auto terms = fogcomp::parse_effects("bias,bias_temperature:order=3");
  for (const char* const effect :
       {"bias", "bias_temperature:order=3", "", "thermal_lag,warm_up", "no_such_effect"}) {
    EXPECT_THROW(fogcomp::change_effect(terms, effect), fogcomp::InputError) << effect;
  }
}

}  // namespace
