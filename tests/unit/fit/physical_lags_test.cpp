#include "fit/physical_lags.hpp"

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

double fitted_lag_s(const char* effect, double tau_s, bool gradient) {
  std::vector<runs::Run> runs{runs::run_of(coil_behind(tau_s, gradient), {10})};
  model::Model model = fog::test::model_of(model::parse_effects(std::string("bias,") + effect));
  series::SignalSeries series(model);
  series.add(runs[0].blocks);
  identify(model, series);
  const std::vector<PhysicalLag> lags = physical_lags(model, runs, false);
  EXPECT_EQ(lags.size(), 1U);
  return lags.empty() ? 0 : lags[0].value_s;
}

TEST(PhysicalLags, AreThoseOfTheCoilAndNotOfTheBoardsDerivative) {
  // Its corners are sharper than the board's derivative: the fit leaves 1.5 times the noise.
  EXPECT_NEAR(fitted_lag_s("shupe", 300, true), 300, 0.1 * 300);
  EXPECT_NEAR(fitted_lag_s("thermal_lag", 900, false), 900, 0.05 * 900);
}

TEST(PhysicalLags, AreNoneWhereNoLagIsIdentified) {
  const std::vector<runs::Run> runs{runs::run_of(coil_behind(300, true), {10})};
  EXPECT_TRUE(physical_lags(fog::test::model_of(model::parse_effects("bias,shupe:tau=60,warm_up")),
                            runs, false)
                  .empty());
}

}  // namespace
}  // namespace fogcomp::fit
