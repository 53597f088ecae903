#include "fit/reference_values.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kDphPerDps = 3600;

// The sample gyro's soaks and ramps on a rate table that turns both ways, faster when it is warm.
// All of its error is a scale factor of 200 ppm at 20 degC and -40 ppm/degC.
recording::Recording on_a_rate_table() {
  recording::Recording recording =
      fog::test::recording_of(fog::test::model_of({}), fog::test::kQuietNoise, 1);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double degc = recording.temperature_degc[i];
    const double turn = static_cast<double>(i / 30 % 5) - 2;  // 5 minutes each
    const double rate = (2 + degc / 40) * turn * kDphPerDps;
    recording.input_rate_dph.push_back(rate);
    recording.rate_dph[i] += rate * (1 + 1e-6 * (200 - 40 * (degc - 20)));
  }
  return recording;
}

model::Model fitted(const std::string& effects) {
  const recording::Recording recording = on_a_rate_table();
  model::Model model = fog::test::model_of(model::parse_effects(effects));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  identify(model, series);
  return model;
}

TEST(ReferenceValues, AreTakenFromTheRowsOnceAndKept) {
  const recording::Recording recording = on_a_rate_table();
  model::Model model = fog::test::model_of(
      model::parse_effects("scale_factor_temperature,scale_factor_nonlinearity"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  set_references(model.terms, series);
  double weights = 0;
  double weighted = 0;
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    weights += std::pow(recording.input_rate_dph[i], 2);
    weighted += std::pow(recording.input_rate_dph[i], 2) * recording.temperature_degc[i];
  }
  EXPECT_NEAR(model.terms[0].parameters[1].value, weighted / weights, 0.01);
  EXPECT_NEAR(model.terms[1].parameters[1].value, 7, 1e-9);  // 2 * (2 + 60 / 40) deg/s
  const std::vector<model::EffectTerm> first = model.terms;
  recording::Recording warmer = recording;
  for (double& degc : warmer.temperature_degc) degc += 10;
  series::SignalSeries later(model);
  later.add(series::make_blocks(warmer));
  set_references(model.terms, later);
  EXPECT_EQ(model.terms[0].shape(), first[0].shape());
  EXPECT_EQ(model.terms[1].shape(), first[1].shape());
}

TEST(ReferenceValues, GivenOnesStay) {
  const model::Model model = fitted("bias,scale_factor_temperature:reference=-12.5");
  EXPECT_EQ(model.terms[1].parameters[1].value, -12.5);
}

// The first listed coefficient should be the largest: about 20 degC the slope would include the
// constant if all rates are at other temperatures.
TEST(ReferenceValues, MakeTheSlopeTheSameWithTheConstantAndWithout) {
  const model::Model alone = fitted("bias,scale_factor_temperature");
  const model::Model both = fitted("bias,scale_factor,scale_factor_temperature");
  EXPECT_NEAR(model::natural_coefficient(alone.terms[1], 0).value, -40, 0.5);
  EXPECT_NEAR(model::natural_coefficient(both.terms[2], 0).value, -40, 0.5);
  const double reference = both.terms[2].parameters[1].value;
  EXPECT_NEAR(model::natural_coefficient(both.terms[1], 0).value, 200 - 40 * (reference - 20), 5);
}

// Of a transition that the recordings do not pass they show a tail only.
TEST(ReferenceValues, BoundAPlaceToTheRecordedTemperatures) {
  const recording::Recording recording = on_a_rate_table();
  const auto [cold, warm] =
      std::minmax_element(recording.temperature_degc.begin(), recording.temperature_degc.end());
  model::Model model =
      fog::test::model_of(model::parse_effects("glass_transition,thermal_hysteresis"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  set_references(model.terms, series);
  ASSERT_TRUE(model.terms[0].parameters[0].bounds.are_given());
  EXPECT_NEAR(model.terms[0].parameters[0].bounds.min, *cold, 1);
  EXPECT_NEAR(model.terms[0].parameters[0].bounds.max, *warm, 1);
  EXPECT_FALSE(model.terms[1].parameters[0].bounds.are_given());

  std::vector<model::EffectTerm> given = model::parse_effects("glass_transition:tg=?[-55,-50]");
  set_references(given, series);
  EXPECT_EQ(given[0].parameters[0].bounds.min, -55);
  std::vector<model::EffectTerm> found = model::parse_effects("glass_transition");
  found[0].coefficients_dph = {0.1, 0.1};
  found[0].parameters[0].value = *cold - 20;
  set_references(found, series);
  EXPECT_EQ(found[0].parameters[0].value, *cold - 20);
}

}  // namespace
}  // namespace fogcomp::fit
