#include "fit/gyro_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

// A gradient of exactly K d(T - Tc)/dt, or the rate of Tc, in rows of 10 s from steps of 1 s.
recording::Recording coil_behind(double tau_s, bool gradient) {
  recording::Recording recording = fog::test::recording_of(fog::test::truth(), {}, 1);
  constexpr int kSteps = 10;
  constexpr double kPerMinute = 60;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.004);
  double inside = recording.temperature_degc[0];
  for (std::size_t row = 0; row + 1 < recording.rows(); ++row) {
    const double step =
        (recording.temperature_degc[row + 1] - recording.temperature_degc[row]) / kSteps;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double outside = recording.temperature_degc[row] + step * (i + 1);
      const double follows = -std::expm1(-1 / tau_s) * (outside - inside);
      inside += follows;
      sum += kPerMinute * (gradient ? step - follows : follows);
    }
    recording.rate_dph[row] = 0.5 + 0.12 * sum / kSteps + noise(random);
  }
  return recording;
}

model::EffectTerm fitted(const char* effect, const recording::Recording& recording) {
  model::Model model = fog::test::model_of(model::parse_effects(std::string("bias,") + effect));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  identify(model, series);
  return model.terms.back();
}

TEST(FitGyro, FindsTheLagOfTheCoilAndNotThatOfTheBoardsDerivative) {
  // Its corners are sharper than the board's derivative: the fit leaves 1.5 times the noise.
  EXPECT_NEAR(model::shape_value(fitted("shupe", coil_behind(300, true)), 0).value, 300, 0.1 * 300);
  EXPECT_NEAR(model::shape_value(fitted("thermal_lag", coil_behind(900, false)), 0).value, 900,
              0.05 * 900);
}

// b = b1 (T - 20) + K dT/dt, read by a thermometer with steps of 1 degC.
TEST(FitGyro, IsNotMisledByACoarseThermometer) {
  recording::Recording recording = fog::test::recording_of(fog::test::truth(), {}, 1);
  constexpr double kPerDegc = 2e-4;
  constexpr double kK = -0.136;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  const std::vector<double> degc = recording.temperature_degc;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const double before = degc[row == 0 ? 0 : row - 1];
    const double after = degc[std::min(row + 1, recording.rows() - 1)];
    const double per_min = (after - before) / 20 * 60;
    recording.rate_dph[row] = kPerDegc * (degc[row] - 20) + kK * per_min + noise(random);
    recording.temperature_degc[row] = std::round(degc[row]);
  }
  model::Model model =
      fog::test::model_of(model::parse_effects("bias,bias_temperature:order=1,temperature_rate"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  identify(model, series);
  const model::Estimate b1 = model::natural_coefficient(*model.find("bias_temperature"), 0);
  const model::Estimate k = model::natural_coefficient(*model.find("temperature_rate"), 0);
  EXPECT_NEAR(b1.value, kPerDegc, 3 * b1.sigma);
  EXPECT_NEAR(k.value, kK, 3 * k.sigma);
  EXPECT_LT(k.sigma, 0.02);
}

// The drift of the rate is a minute late: what that leaves of each ramp is no random walk.
TEST(FitGyro, ALateRate_IsNoSlowNoise) {
  constexpr double kLate_s = 60;
  const recording::Recording late = coil_behind(kLate_s, false);
  model::Model model = fog::test::model_of(model::parse_effects("bias,temperature_rate"));
  series::SignalSeries series(model);
  series.add(series::make_blocks(late));
  identify(model, series);
  ASSERT_TRUE(model.uncertainty);
  EXPECT_LT(model.uncertainty->walk_dph_per_rth, 0.004);
}

TEST(FitGyro, KnowsTheNoiseBesideTheDrift) {
  model::Model model = fog::test::truth();
  series::SignalSeries series(model);
  series.add(series::make_blocks(fog::test::recording_of(model, {0.024, 0, 600}, 3)));
  identify(model, series);
  ASSERT_TRUE(model.uncertainty);
  EXPECT_NEAR(model.uncertainty->white_dph, 0.024, 0.002);
  EXPECT_EQ(model.uncertainty->covariance.rows(), model::unknowns_of(model));
  EXPECT_EQ(model.uncertainty->turn_on_dph, 0);
}

}  // namespace
}  // namespace fogcomp::fit
