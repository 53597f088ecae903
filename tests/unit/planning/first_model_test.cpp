#include "planning/first_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <string>

namespace fogcomp::planning {
namespace {

constexpr double kRow_s = 10;
constexpr double kTau_s = 30;

// Rows of 10 s; `drift`: of the temperature and its rate, degC/min.
std::string first_effects(int rows, const std::function<double(double)>& degc_at,
                          const std::function<double(double, double)>& drift,
                          double input_dph = 0) {
  recording::Recording recording;
  recording.period_s = kRow_s;
  recording.stretch_starts = {0};
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.01);
  for (int i = 0; i < rows; ++i) {
    const double at = kRow_s * i;
    const double rate = (degc_at(at + 1) - degc_at(at - 1)) / 2 * 60;
    const double turned = i % 60 < 30 ? input_dph : -input_dph;
    recording.time_s.push_back(at);
    recording.temperature_degc.push_back(degc_at(at));
    if (input_dph != 0) recording.input_rate_dph.push_back(turned);
    recording.rate_dph.push_back(turned * (1 + 1e-4) + drift(degc_at(at), rate) + noise(random));
  }
  return prospect_of(series::make_blocks(recording), kRow_s, kTau_s).first_effects;
}

double warming_up(double at_s) {
  return 60 - 50 * std::exp(-at_s / 600);
}

double up_and_down(double at_s) {
  return 20 + 30 * std::sin(at_s / 2000);
}

double cubic(double degc, double rate) {
  static_cast<void>(rate);
  const double x = (degc - 35) / 25;
  return 0.5 * x + 0.2 * x * x * x;
}

double following(double degc, double rate) {
  return 0.01 * degc + 0.1 * rate;
}

TEST(FirstModel, GyroThatWarmsItselfUp_HasNoRate) {
  EXPECT_EQ(first_effects(360, warming_up, cubic), "bias,bias_temperature:order=3");
  EXPECT_EQ(first_effects(360, warming_up, following), "bias,bias_temperature:order=3");
}

TEST(FirstModel, RateThatTheRecordingShows_IsInIt) {
  EXPECT_EQ(first_effects(2000, up_and_down, following), model::kFirstEffects);
}

TEST(FirstModel, CubeThatTheRecordingShows_IsInIt) {
  EXPECT_EQ(first_effects(2000, up_and_down, cubic), "bias,bias_temperature:order=3");
}

TEST(FirstModel, TurnedGyro_HasAScaleFactor) {
  EXPECT_EQ(first_effects(2000, up_and_down, following, 3.6e5),
            std::string(model::kFirstEffects) + ",scale_factor");
}

TEST(FirstModel, SteadyTemperature_IsTheUsualOne) {
  EXPECT_EQ(first_effects(
                360, [](double) { return 20.0; }, following),
            model::kFirstEffects);
}

}  // namespace
}  // namespace fogcomp::planning
