#include "fit/identify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/typical_effects.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

using fog::test::truth;
using model::Model;

// A model of the same effects as the truth, coefficients unknown.
Model unknown() {
  Model model = truth();
  for (model::EffectTerm& term : model.terms) term.coefficients_dph.clear();
  return model;
}

Identification fit(Model& model, const recording::Recording& recording) {
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  return identify(model, series);
}

TEST(Identify, ReturnsTheTruthExactlyWithoutNoise) {
  Model model = unknown();
  fit(model, fog::test::recording_of(truth(), {1e-9, 0, 300}, 1));
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    for (std::size_t k = 0; k < model.terms[i].coefficients_dph.size(); ++k) {
      EXPECT_NEAR(model.terms[i].coefficients_dph[k].value,
                  truth().terms[i].coefficients_dph[k].value, 1e-7);
    }
  }
}

// Ramps of 0.5 degC/min up and down, and the power on for 20 of every 40 min.
recording::Recording powered_on_in_ramps() {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.05);
  recording::Recording recording;
  recording.file = "ramps.csv";
  recording.period_s = 1;
  for (int second = 0; second < 12 * 3600; ++second) {
    if (second % 2400 >= 1200) continue;
    const double in_ramp_min = second % 7200 / 60.0;
    const bool is_up = second / 7200 % 2 == 0;
    recording.time_s.push_back(second);
    recording.uptime_s.push_back(second % 2400);
    recording.temperature_degc.push_back(is_up ? 0.5 * in_ramp_min : 60 - 0.5 * in_ramp_min);
    recording.rate_dph.push_back(0.5 + (is_up ? 0.1 : -0.1) + noise(random));
  }
  recording.stretch_starts = {0};
  return recording;
}

TEST(Identify, PoweredOnInRamps_TheBoardsCoefficientsAreThoseOfASettledDerivative) {
  Model model = fog::test::model_of(model::parse_effects("bias,temperature_rate"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(powered_on_in_ramps()));
  IdentifySettings settings;
  settings.run_offsets = true;
  identify(model, series, settings);
  const model::EffectTerm& rate = model.terms[1];
  EXPECT_NEAR(rate.coefficients_dph[0].value / rate.gyro->coefficients_dph[0].value, 1, 0.1);
}

// Nothing is known about the time of a gap.
TEST(Identify, KeepsWhatTheRecordingsCoverOfTheirInputs) {
  Model model = unknown();
  series::SignalSeries series(model);
  recording::Recording recording = fog::test::recording_of(truth(), {0.024, 0, 300}, 1);
  auto& supply = recording[fog::Input::supply];
  supply.assign(recording.rows(), 5.25);
  std::fill(supply.begin() + 100, supply.end(), 5.0);
  supply.back() = 4.875;
  series.add(series::make_blocks(recording));
  supply.clear();
  series.add(series::make_blocks(recording));
  supply.assign(recording.rows(), 5.5);
  std::fill(supply.begin() + 100, supply.end(), 5.0);
  for (std::size_t row = 100; row < recording.rows(); ++row) recording.time_s[row] += 1000;
  series.add(series::make_blocks(recording));
  identify(model, series);
  const auto& range = model.input_ranges[extension_number(fog::Input::supply)];
  ASSERT_TRUE(range.has_value());
  EXPECT_EQ(range->range.min, 4.875);
  EXPECT_EQ(range->range.max, 5.5);
  EXPECT_EQ(range->step, 0.25);
  EXPECT_FALSE(model.input_ranges[extension_number(fog::Input::magnetic)].has_value());
}

TEST(Identify, IsNotMovedByOutliers) {
  recording::Recording recording = fog::test::recording_of(truth(), {0.024, 0, 300}, 1);
  Model clean = unknown();
  fit(clean, recording);
  for (std::size_t row = 50; row < recording.rows(); row += 200) recording.rate_dph[row] += 3;
  Model spoilt = unknown();
  const auto result = fit(spoilt, recording);
  EXPECT_GE(result.outliers, recording.rows() / 200);
  for (std::size_t i = 0; i < clean.terms.size(); ++i) {
    for (std::size_t k = 0; k < clean.terms[i].coefficients_dph.size(); ++k) {
      EXPECT_NEAR(spoilt.terms[i].coefficients_dph[k].value,
                  clean.terms[i].coefficients_dph[k].value,
                  1.5 * clean.terms[i].coefficients_dph[k].sigma);
    }
  }
}

TEST(Identify, TakesSeveralRecordingsTogether) {
  Model one = unknown();
  fit(one, fog::test::recording_of(truth(), {0.024, 0, 300}, 1));
  Model both = unknown();
  series::SignalSeries series(both);
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
    series.add(series::make_blocks(fog::test::recording_of(truth(), {0.024, 0, 300}, seed)));
  }
  identify(both, series);
  // Less than the root of a half: one recording alone shows less of its slow noise, too.
  const double ratio =
      both.terms[0].coefficients_dph[0].sigma / one.terms[0].coefficients_dph[0].sigma;
  EXPECT_LT(ratio, std::sqrt(0.5) + 0.1);
  EXPECT_GT(ratio, 0.3);
}

TEST(Identify, LetsEveryRecordingHaveABiasOfItsOwn) {
  Model model = unknown();
  series::SignalSeries series(model);
  recording::Recording second = fog::test::recording_of(truth(), {0.024, 0, 300}, 2);
  for (double& rate : second.rate_dph) rate += 0.1;
  series.add(series::make_blocks(fog::test::recording_of(truth(), {0.024, 0, 300}, 1)));
  series.add(series::make_blocks(second));
  const auto result = identify(model, series, {true});
  ASSERT_EQ(result.run_offsets_dph.size(), 1U);
  EXPECT_NEAR(result.run_offsets_dph[0], 0.1, 0.003);
  // The model has the mean of both.
  EXPECT_NEAR(model.terms[0].coefficients_dph[0].value,
              truth().terms[0].coefficients_dph[0].value + 0.05,
              5 * model.terms[0].coefficients_dph[0].sigma);
  EXPECT_NEAR(model.terms[2].coefficients_dph[0].value, truth().terms[2].coefficients_dph[0].value,
              5 * model.terms[2].coefficients_dph[0].sigma);
}

// Power-ons at one temperature each, every temperature twice: within one of them next to nothing
// shows what the bias does with temperature, and between them it is as uncertain as biases vary.
TEST(Identify, FindsADriftWithTemperatureBetweenPowerOnsOfOneTemperatureEach) {
  const std::vector<double> biases_dph{0.1, -0.2, 0.15, -0.05, -0.12, 0.08, 0.2, -0.15};
  Model model = fog::test::model_of(model::parse_effects("bias,bias_temperature:order=1"));
  series::SignalSeries series(model);
  for (std::size_t i = 0; i < biases_dph.size(); ++i) {
    recording::Recording run = fog::test::static_recording(-30 + 20 * static_cast<double>(i % 4),
                                                           0.001, {0.024, 0, 300}, i + 1);
    for (std::size_t row = 0; row < run.rows(); ++row) {
      run.rate_dph[row] += 5 + biases_dph[i] + 0.02 * (run.temperature_degc[row] - 20);
    }
    series.add(series::make_blocks(run));
  }
  const auto result = identify(model, series, {true});
  EXPECT_NEAR(result.turn_on_repeatability_dph, 0.15, 0.06);
  const model::EffectTerm& slope = model.terms[1];
  constexpr double kUnitDegc = 64;  // of a coefficient
  EXPECT_LT(slope.coefficients_dph[0].sigma, 0.005 * kUnitDegc);
  EXPECT_NEAR(slope.coefficients_dph[0].value, 0.02 * kUnitDegc,
              4 * slope.coefficients_dph[0].sigma);
  EXPECT_NEAR(model.terms[0].coefficients_dph[0].value, 5,
              4 * model.terms[0].coefficients_dph[0].sigma);
}

TEST(Identify, SaysInWordsWhichEffectsCannotBeToldApart) {
  Model model = unknown();
  // At one temperature bias and slope are the same: it gets almost no other data.
  recording::Recording recording = fog::test::recording_of(truth(), {0.024, 0, 300}, 1);
  for (double& temperature : recording.temperature_degc)
    temperature = 50 + 0.01 * (temperature - 20);
  model.terms = model::parse_effects("bias,bias_temperature:order=1");
  const auto result = fit(model, recording);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_EQ(result.warnings[0],
            "`bias` and `bias_temperature` are 1.00 correlated on these data: their sum is known, "
            "their split is not");
}

TEST(Identify, RefusesWhatTheDataCannotDetermine) {
  Model model = unknown();
  recording::Recording recording = fog::test::recording_of(truth(), {0.024, 0, 300}, 1);
  for (double& temperature : recording.temperature_degc) temperature = 25;
  EXPECT_THROW(fit(model, recording), InputError);
}

// Whether the coil leads or lags the sensor shows only at the corners of ramps, where it hardly
// exceeds the sensor's noise.
TEST(Identify, IsNotMisledByTheNoiseOfTheTemperatureSensor) {
  Model real = truth();
  real.terms.push_back(fog::test::natural_term("thermal_lag", {60}, {-0.2}));
  auto recording = fog::test::recording_of(real, {0.002, 0, 300}, 1);
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.06);
  for (double& temperature : recording.temperature_degc) temperature += noise(random);
  Model model = real;
  fit(model, recording);
  const double found = model.terms.back().coefficients_dph[0].value;
  EXPECT_NEAR(found / real.terms.back().coefficients_dph[0].value, 1, 0.1);
}

// Two play operators, the second disabled by default; the narrower is the first, wherever the
// search began.
TEST(Identify, FindsASecondRadiusOfHysteresisWhereAsked) {
  Model real = truth();
  real.terms.push_back(fog::test::natural_term("thermal_hysteresis", {4, 17}, {0.06, 0.09}));
  const auto recording = fog::test::recording_of(real, {0.024, 0.003, 300}, 2);
  const std::string others = "bias,bias_temperature:order=3,temperature_rate,";
  for (const char* effect :
       {"thermal_hysteresis:radius2=?", "thermal_hysteresis:radius=?[1,10],radius2=?[10,30]"}) {
    Model model = unknown();
    model.terms = model::parse_effects(others + effect);
    fit(model, recording);
    const model::EffectTerm& term = model.terms.back();
    ASSERT_EQ(term.coefficients_dph.size(), 2U) << effect;
    EXPECT_NEAR(term.parameters[0].value, 4, 4 * term.parameters[0].sigma) << effect;
    EXPECT_NEAR(term.parameters[1].value, 17, 4 * term.parameters[1].sigma) << effect;
    EXPECT_LT(term.parameters[1].sigma, 2) << effect;
    EXPECT_NEAR(term.coefficients_dph[0].value, 0.06, 4 * term.coefficients_dph[0].sigma) << effect;
    EXPECT_NEAR(term.coefficients_dph[1].value, 0.09, 4 * term.coefficients_dph[1].sigma) << effect;
  }
  Model one = unknown();
  one.terms = model::parse_effects(others + "thermal_hysteresis");
  fit(one, recording);
  EXPECT_EQ(one.terms.back().coefficients_dph.size(), 1U);
}

// An effect beside those of the sample gyro, fitted to a recording of one that has it.
class FittedBeside {
 public:
  explicit FittedBeside(const model::EffectTerm& hidden) {
    Model real = truth();
    real.terms.push_back(hidden);
    recording_ = fog::test::recording_of(real, {0.024, 0.003, 300}, 2);
  }
  model::EffectTerm operator()(const std::string& effect) const {
    Model model = unknown();
    model.terms = model::parse_effects("bias,bias_temperature:order=3,temperature_rate," + effect);
    fit(model, recording_);
    return model.terms.back();
  }

 private:
  recording::Recording recording_;
};

TEST(Identify, FindsHowMuchFasterAnAgeingIsWhenWarmWhereAsked) {
  const FittedBeside fitted(fog::test::natural_term("aging", {5000, 1.4}, {0.2}));
  const model::EffectTerm term = fitted("aging:q10=?");
  EXPECT_NEAR(term.parameters[1].value, 1.4, 4 * term.parameters[1].sigma);
  EXPECT_LT(term.parameters[1].sigma, 0.1);
  EXPECT_EQ(fitted("aging").parameters[1].value, 1);
}

TEST(Identify, FindsHowLateATransitionFreezesWhereAsked) {
  const FittedBeside fitted(fog::test::natural_term("glass_transition", {10, 4, 360}, {0.2, 0.14}));
  const model::EffectTerm term = fitted("glass_transition:lag=?");
  EXPECT_NEAR(term.parameters[0].value, 10, 4 * term.parameters[0].sigma);
  EXPECT_NEAR(term.parameters[2].value, 360, 4 * term.parameters[2].sigma);
  EXPECT_LT(term.parameters[2].sigma, 120);
  EXPECT_EQ(fitted("glass_transition").parameters[2].value, 0);
}

TEST(EffectList, KeepsWhatIsGivenAndLeavesTheRestToTheFit) {
  const auto terms = model::parse_effects("bias,bias_temperature:order=3,temperature_rate");
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[1].shape(), std::vector<double>{3});
  EXPECT_FALSE(terms[1].parameters[0].identified);
}

TEST(EffectList, TakesAQuestionMarkAndItsBounds) {
  const auto terms = model::parse_effects("bias,thermal_hysteresis:radius=7,radius2=?[5,20],shupe");
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_FALSE(terms[1].parameters[0].identified);
  EXPECT_TRUE(terms[1].parameters[1].identified);
  EXPECT_EQ(terms[1].parameters[1].bounds.min, 5);
  EXPECT_EQ(terms[1].parameters[1].bounds.max, 20);
  EXPECT_GE(terms[1].parameters[1].value, 5);
  EXPECT_LE(terms[1].parameters[1].value, 20);
  for (const char* wrong : {"bias_temperature:order=?", "shupe:tau=?[1,30]", "shupe:tau=?[30,20]",
                            "shupe:tau=?[30]", "shupe:tau=?30", "shupe:tau=[1,2]"}) {
    EXPECT_THROW(model::parse_effects(wrong), InputError) << wrong;
  }
}

}  // namespace
}  // namespace fogcomp::fit
