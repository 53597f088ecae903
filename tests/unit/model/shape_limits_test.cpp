#include "model/shape_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "model/model_file.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::model {
namespace {

EffectTerm fitted(const std::string& effect, double value, double sigma) {
  EffectTerm term = parse_effects(effect)[0];
  term.parameters[0].value = value;
  term.parameters[0].sigma = sigma;
  return term;
}

std::string doubt(const EffectTerm& term) {
  const std::vector<std::string> doubts = shape_doubts(term);
  return doubts.empty() ? "" : doubts[0];
}

TEST(ShapeLimits, NameTheBoundAndWhatDoesAsWell) {
  EXPECT_EQ(doubt(fitted("aging", 2e6, 1e5)),
            "`aging`: t0 is at its upper bound 2e+06 s: a line in time would do as well");
  EXPECT_EQ(doubt(fitted("warm_up", 18000, 100)),
            "`warm_up`: tau is at its upper bound 18000 s: a line in time would do as well");
  EXPECT_EQ(doubt(fitted("thermal_lag", 5, 1)),
            "`thermal_lag`: tau is at its lower bound 5 s: temperature_rate would do as well");
  EXPECT_EQ(doubt(fitted("thermal_hysteresis:radius=?[1,9]", 1, 0.1)),
            "`thermal_hysteresis`: radius is at its lower bound 1 degC: these data would have it "
            "smaller still");
  EffectTerm written = expression_term("x = T * ?k[1e-13, 1e-11]");
  written.parameters[0].value = 1e-11;
  EXPECT_EQ(doubt(written),
            "`x`: k is at its upper bound 1e-11: these data would have it larger still");
}

TEST(ShapeLimits, KnowWhereOnlyATailOfAnEffectIsSeen) {
  EXPECT_TRUE(only_tail_is_seen(fitted("glass_transition:tg=?[-35,65]", -35, 1)));
  EXPECT_FALSE(only_tail_is_seen(fitted("glass_transition:tg=?[-35,65]", -20, 1)));
  EXPECT_FALSE(only_tail_is_seen(fitted("aging", 2e6, 1e5)));
}

TEST(ShapeLimits, NameAParameterThatMayBeAnywhere) {
  EXPECT_EQ(doubt(fitted("warm_up", 9000, 1e6)),
            "`warm_up`: tau is not determined: 9000 +- 1e+06, anywhere from 10 to 18000 s");
  EXPECT_EQ(doubt(fitted("warm_up", 1200, 100)), "");
  EXPECT_EQ(doubt(fitted("warm_up:tau=18000", 18000, 0)), "");  // given
}

TEST(ShapeLimits, NameAnEffectThatIsNotSeen) {
  EffectTerm term = parse_effects("bias")[0];
  term.coefficients_dph = {{-1, 0.5}};
  EXPECT_EQ(coefficient_doubt(term), "");
  term.coefficients_dph = {{-1, 1.5}};
  EXPECT_EQ(coefficient_doubt(term),
            "`bias`: none of its coefficients is larger than its uncertainty");
}

// The model of some effects after the first rows of the sample gyro's run, with a further bias.
Model fitted_to(std::size_t rows, const std::string& effects, double bias_dph = 0) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (auto* column : {&recording.time_s, &recording.temperature_degc, &recording.rate_dph}) {
    column->resize(std::min(rows, column->size()));
  }
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    recording.temperature_degc[row] += 0.001 * static_cast<double>(row * row % 7);  // a sensor's
    recording.rate_dph[row] += bias_dph;
  }
  Model model = fog::test::model_of(parse_effects(effects));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  fit::identify(model, series);
  return model;
}

TEST(UncertainFit, IsMarkedWhereNoCompensationWouldDoBetter) {
  const Model model = fitted_to(30, "bias,bias_temperature");
  ASSERT_TRUE(model.uncertain.has_value());
  EXPECT_GT(model.uncertain->sigma_dph, model.uncertain->drift_dph);
  const Model read = parse_model(model_text(model), "written");
  ASSERT_TRUE(read.uncertain.has_value());
  EXPECT_EQ(read.uncertain->sigma_dph, model.uncertain->sigma_dph);
  EXPECT_FALSE(read.uncertain->at_power_on);
}

TEST(UncertainFit, IsMarkedWhateverTheBias) {
  EXPECT_TRUE(fitted_to(30, "bias,bias_temperature", 1e8).uncertain.has_value());
}

TEST(UncertainFit, IsNotMarkedWhereTheDataSufficeForTheEffects) {
  EXPECT_FALSE(fitted_to(30, "bias").uncertain.has_value());
  EXPECT_FALSE(fitted_to(30, "bias", 1e8).uncertain.has_value());
  EXPECT_FALSE(fitted_to(100000, "bias,bias_temperature").uncertain.has_value());
}

// A second sensor that differs from the first by hundredths of a degree, as it will in any soak:
// its effect is small although its coefficient is not well known.
TEST(UncertainFit, LetsASecondSensorFollowTheFirst) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const double apart = 0.05 * std::sin(static_cast<double>(row) / 30);
    recording[fog::Input::temperature2].push_back(recording.temperature_degc[row] + apart);
  }
  Model model = fog::test::model_of(
      parse_effects("bias,bias_temperature:order=3,temperature_rate,axial_gradient:tau=20"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  fit::identify(model, series);
  EXPECT_GT(50 * model.terms[3].coefficients_dph[0].sigma, 0.5);  // 50 degC apart it would be
  EXPECT_FALSE(model.uncertain.has_value());
}

// A model with a warm-up of some time constant after a recording that began so late.
Model warmed_up(double began_s) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1);
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    recording.rate_dph[row] += 0.3 * std::exp(-recording.time_s[row] / 1200);
    recording.time_s[row] += began_s;
  }
  Model model = fog::test::model_of(parse_effects("bias,bias_temperature:order=3,warm_up"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  fit::identify(model, series);
  return model;
}

// A board begins at power-on, where a warm-up is largest.
TEST(UncertainFit, IsMarkedWhereARecordingBeganTooLateForAWarmUp) {
  EXPECT_FALSE(warmed_up(0).uncertain.has_value());
  const Model late = warmed_up(40000);
  ASSERT_TRUE(late.uncertain.has_value());
  EXPECT_TRUE(late.uncertain->at_power_on);
  EXPECT_TRUE(parse_model(model_text(late), "written").uncertain->at_power_on);
}

}  // namespace
}  // namespace fogcomp::model
