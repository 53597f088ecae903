#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "compare/comparison.hpp"
#include "fit/identify.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

constexpr double kDelayS = 0.02;
constexpr double kErrorPpm = 500;

// An hour at 1 Hz: sweeps of +-100 deg/s every 31 s, with others every 90 s, the record behind, 0.5
// deg/h of noise.
recording::Recording sweeps(double delay_s, double others_dph = 0) {
  recording::Recording recording;
  recording.file = "sweeps";
  recording.period_s = 1;
  recording.stretch_starts = {0};
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.5);
  const auto rate_dph = [&](double t) {
    return 360000 * std::sin(2 * M_PI * t / 31) + others_dph * std::sin(2 * M_PI * t / 90);
  };
  for (int i = 0; i < 3600; ++i) {
    recording.time_s.push_back(i);
    recording.temperature_degc.push_back(20 + 5 * std::sin(i / 300.0));
    recording.rate_dph.push_back(rate_dph(i) * (1 + 1e-6 * kErrorPpm) + noise(random));
    recording.input_rate_dph.push_back(rate_dph(i - delay_s));
  }
  return recording;
}

model::Model fitted_to(const recording::Recording& recording, const std::string& late) {
  model::Model model = fog::test::model_of(model::parse_effects("bias,scale_factor," + late));
  model.average_s = 1;
  series::SignalSeries series(model);
  series.add(series::make_blocks(recording));
  identify(model, series);
  return model;
}

// The remaining error of the delay is of second order, 8 ppm of the rate, and as much from the
// derivative over 1 s of a sweep of 31 s. A derivative that is half a block late would leave 2,000
// ppm.
TEST(LateReference, IsFoundBesideTheScaleFactorAndTakenOut) {
  const recording::Recording recording = sweeps(kDelayS);
  const model::Model model = fitted_to(recording, "late_reference");
  EXPECT_NEAR(model::natural_coefficient(model.terms[1], 0).value, kErrorPpm, 20);
  EXPECT_NEAR(model::natural_coefficient(model.terms[2], 0).value, 1000 * kDelayS,
              0.05 * 1000 * kDelayS);
  const runs::Run run = runs::run_of(recording, {1});
  const double delay_drift_dph = kDelayS * 360000 * 2 * M_PI / 31 / std::sqrt(2);
  EXPECT_LE(compare::compare_with(model, run, 1).whole.rms_dph, 0.06 * delay_drift_dph);
}

// Sweeps of one period have the second order in common with the scale factor, of two they do not.
TEST(LateReference, IsFoundToSecondOrder) {
  const recording::Recording recording = sweeps(0.2, 200000);
  const model::Model first = fitted_to(recording, "late_reference");
  const model::Model second = fitted_to(recording, "late_reference:near=?");
  EXPECT_GT(std::abs(model::natural_coefficient(first.terms[1], 0).value - kErrorPpm), 400);
  EXPECT_NEAR(model::natural_coefficient(second.terms[1], 0).value, kErrorPpm, 100);
  EXPECT_NEAR(second.terms[2].parameters[0].value, 200, 20);
  EXPECT_NEAR(model::natural_coefficient(second.terms[2], 0).value, 200, 2);
  const runs::Run run = runs::run_of(recording, {1});
  EXPECT_LE(compare::compare_with(second, run, 1).whole.rms_dph,
            0.1 * compare::compare_with(first, run, 1).whole.rms_dph);
}

// Half an hour at 10 Hz: the table goes from one rate to another at 50 deg/s^2 every 13.7 s, so
// that most of its flanks end within a row of 1 s, and turns when the record begins.
recording::Recording flanks() {
  recording::Recording recording;
  recording.file = "flanks";
  recording.period_s = 0.1;
  recording.stretch_starts = {0};
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise(0, 1.5);
  std::uniform_real_distribution<double> rates(-200, 200);
  constexpr int kSteps = 100;  // of the table's motion, in a sample
  std::vector<double> rate_dph;
  double rate_dps = -100;
  double wanted_dps = 150;
  for (int i = 0; i < 18000 * kSteps; ++i) {
    if (i % (137 * kSteps) == 0 && i > 0) wanted_dps = rates(random);
    const double step = 50 * 0.1 / kSteps;
    rate_dps += std::clamp(wanted_dps - rate_dps, -step, step);
    rate_dph.push_back(3600 * rate_dps);
  }
  const auto mean_of = [&](int sample, int late) {
    double sum = 0;
    for (int i = sample * kSteps; i < (sample + 1) * kSteps; ++i) {
      sum += rate_dph[static_cast<std::size_t>(std::max(i - late, 0))];
    }
    return sum / kSteps;
  };
  constexpr int kLate = 20;  // 20 ms
  for (int i = 0; i < 18000; ++i) {
    recording.time_s.push_back(0.1 * i);
    recording.temperature_degc.push_back(20 + 5 * std::sin(i / 3000.0));
    recording.rate_dph.push_back(mean_of(i, 0) * (1 + 1e-6 * kErrorPpm) + noise(random));
    recording.input_rate_dph.push_back(mean_of(i, kLate));
  }
  return recording;
}

// What is left is of second order, 50 deg/s^2 (20 ms)^2 / 2 in the second of each corner: 14 deg/h.
TEST(LateReference, IsFoundWhereTheTablesFlanksAreWithinRows) {
  const recording::Recording recording = flanks();
  const model::Model model = fitted_to(recording, "late_reference");
  EXPECT_NEAR(model::natural_coefficient(model.terms[1], 0).value, kErrorPpm, 10);
  EXPECT_NEAR(model::natural_coefficient(model.terms[2], 0).value, 1000 * kDelayS, 0.1);
  const runs::Run run = runs::run_of(recording, {1});
  EXPECT_LE(compare::compare_with(model, run, 1).whole.rms_dph, 20);
}

}  // namespace
}  // namespace fogcomp::fit
