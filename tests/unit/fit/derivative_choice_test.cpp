#include "fit/derivative_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

// b = K dT/dt of a temperature that swings by +-30 degC, in samples of 1 s; a fine thermometer.
runs::Run swinging(double period_s, std::uint64_t seed) {
  constexpr double kK = 0.12;  // deg/h per degC/min
  constexpr double kSwing_degc = 30;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  recording::Recording recording;
  recording.file = "swinging";
  recording.period_s = 1;
  recording.stretch_starts = {0};
  for (int i = 0; i < 4 * 3600; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / period_s;
    const double per_min = kSwing_degc * std::cos(angle) * 60 * 2 * std::acos(-1.0) / period_s;
    recording.time_s.push_back(i);
    recording.temperature_degc.push_back(kSwing_degc * std::sin(angle) + 0.003 * normal(random));
    recording.rate_dph.push_back(0.5 + kK * per_min + 0.03 * normal(random));
  }
  return runs::run_of(recording, {10});
}

model::Model fitted(const std::vector<runs::Run>& runs, double derivative_tau_s) {
  model::Model model = fog::test::model_of(model::parse_effects("bias,temperature_rate"));
  model.derivative_tau_s = derivative_tau_s;
  identify(model, KnownRegressors(model, runs));
  return model;
}

TEST(DerivativeChoice, IsAShorterOneInFastCyclesAndLeavesLess) {
  const std::vector<runs::Run> runs{swinging(600, 1)};
  const model::Model model = fitted(runs, 30);
  const auto better = better_derivative(model, KnownRegressors(model, runs), runs);
  ASSERT_TRUE(better);
  EXPECT_LT(better->tau_s, 30);
  EXPECT_LT(fitted(runs, better->tau_s).residual_rms_dph, 0.5 * model.residual_rms_dph);
}

TEST(DerivativeChoice, LeavesLessEachTimeAndEndsWithNone) {
  const std::vector<runs::Run> runs{swinging(7200, 1)};
  for (const double first_s : {1.0, 30.0, 300.0}) {
    model::Model model = fitted(runs, first_s);
    int changes = 0;
    while (const auto better = better_derivative(model, KnownRegressors(model, runs), runs)) {
      ASSERT_LT(++changes, 4) << first_s;
      const model::Model next = fitted(runs, better->tau_s);
      EXPECT_LT(next.residual_rms_dph, model.residual_rms_dph) << first_s << ", " << better->tau_s;
      model = next;
    }
  }
}

}  // namespace
}  // namespace fogcomp::fit
