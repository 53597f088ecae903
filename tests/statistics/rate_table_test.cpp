#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "model/effect_list.hpp"
#include "support/typical_effects.hpp"
#include "unit/diagnosis/looped.hpp"
#include "unit/fit/simulated_gyro.hpp"

// Gyros on a rate table in a chamber, 0.6 h at 1 Hz: sweeps while the temperature rises and falls.
namespace {

using fogcomp::diagnosis::Diagnosis;
using fogcomp::diagnosis::Verdict;

constexpr double kNoiseDph = 1;  // of a row of 10 s

double table_rate_dph(double t) {
  if (t < 120 || t > 2040) return 0;
  const bool fast = t < 900 || t > 1400;
  return (fast ? 100 : 30) * 3600 * std::sin(2 * M_PI * t / (fast ? 45 : 75));
}

constexpr double kMeanDegc = 31.5;  // while it sweeps

double temperature_degc(double t) {
  return 25 + 10 * std::sin(t / 650);
}

// Drift of the true rate, and of `error` as a function of it (W, T, dW/dt).
template <class Error>
fogcomp::recording::Recording on_the_table(std::uint64_t seed, const Error& error) {
  fogcomp::recording::Recording recording;
  recording.file = "rate table";
  recording.period_s = 1;
  recording.stretch_starts = {0};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, kNoiseDph * std::sqrt(10.0));
  for (int i = 0; i < 2160; ++i) {
    const double rate = table_rate_dph(i);
    const double change = (table_rate_dph(i + 0.01) - table_rate_dph(i - 0.01)) / 0.02;
    recording.time_s.push_back(i);
    recording.temperature_degc.push_back(temperature_degc(i));
    recording.input_rate_dph.push_back(rate);
    recording.rate_dph.push_back(rate + 2 + noise(random) +
                                 error(rate, temperature_degc(i), change));
  }
  return recording;
}

Diagnosis diagnosed(const fogcomp::recording::Recording& recording, const std::string& effects) {
  const auto model = fog::test::model_of(fogcomp::model::parse_effects(effects));
  fogcomp::diagnosis::DiagnosisData data(model,
                                         {fogcomp::runs::run_of(recording, {model.average_s})});
  return fogcomp::diagnosis::diagnose(model, data);
}

// Of an error, 3 and 10 times the noise of a row.
template <class Error>
void expect_named(const char* effect, const Error& error) {
  for (const double size : {3, 10}) {
    const auto recording = on_the_table(
        static_cast<std::uint64_t>(size),
        [&](double w, double t, double change) { return size * kNoiseDph * error(w, t, change); });
    const Diagnosis diagnosis = diagnosed(recording, "bias,bias_temperature");
    EXPECT_EQ(diagnosis.verdict, Verdict::missing_effect) << effect << ' ' << size;
    EXPECT_EQ(diagnosis.effect, effect) << size;
  }
}

TEST(RateTable, NamesEachErrorOfTheInputRate) {
  expect_named("scale_factor", [](double w, double, double) { return w / 2e5; });
  expect_named("scale_factor_temperature",
               [](double w, double t, double) { return w / 2e5 * (t - kMeanDegc) / 4; });
  expect_named("scale_factor_nonlinearity", [](double w, double, double) {
    const double u = w / 3.6e5;
    return 3 * (5 * u * u * u - 3 * u) / 2;
  });
  expect_named("scale_factor_asymmetry",
               [](double w, double, double) { return std::fabs(w) / 2e5; });
  expect_named("late_reference", [](double, double, double change) { return change / 3e4; });
}

TEST(RateTable, NamesNothingInACleanGyro) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto recording = on_the_table(seed, [](double, double, double) { return 0; });
    EXPECT_EQ(diagnosed(recording, "bias").effect, "") << seed;
  }
}

// No effect describes a loop that saturates: the error is attributed to the input, not to a cycle
// in time.
TEST(RateTable, WhatTheInputRateDrivesIsNotTakenForACycle) {
  const auto recording =
      on_the_table(1, [](double w, double, double) { return 20 * kNoiseDph * std::tanh(w / 2e4); });
  const Diagnosis diagnosis = diagnosed(recording, "bias,bias_temperature");
  EXPECT_NE(diagnosis.verdict, Verdict::none);
  EXPECT_EQ(diagnosis.fast_kind, fogcomp::diagnosis::FastKind::none);
  EXPECT_EQ(diagnosis.variable, "input_rate_dph");
}

// All at once, hundreds of times the noise, and a source that is warmed a minute after the sensor.
// The sweeps are most of the residual, in no soak is the table at rest.
fogcomp::recording::Recording with_a_late_source(std::uint64_t seed) {
  double before_degc = 25;
  return on_the_table(seed, [&](double w, double t, double) {
    const double late_degc = t - 60 * (t - before_degc);
    before_degc = t;
    const double u = w / 3.6e5;
    return w * (2e-3 - 4e-4 * (late_degc - kMeanDegc)) + 100 * (5 * u * u * u - 3 * u) / 2;
  });
}

TEST(RateTable, WhatALateSourceLeavesIsTheTablesAndNoCycle) {
  const Diagnosis late =
      diagnosed(with_a_late_source(5),
                "bias,scale_factor,scale_factor_temperature,scale_factor_nonlinearity");
  EXPECT_GT(late.residual_rms_dph, 10 * kNoiseDph);
  EXPECT_EQ(late.fast_kind, fogcomp::diagnosis::FastKind::none);
}

TEST(RateTable, TheLoopEndsAtTheNoiseAndFindsTheLagOfTheSource) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto model = fog::test::model_of(fogcomp::model::parse_effects("bias"));
    const auto ladder = fog::test::looped(model, with_a_late_source(seed), 4);
    EXPECT_LE(ladder.last.residual_rms_dph, 1.2 * kNoiseDph) << seed;
    for (const fogcomp::model::EffectTerm& term : ladder.model.terms) {
      if (term.name == "scale_factor_temperature") {
        EXPECT_NEAR(term.parameters.back().value, 60, 10) << seed;
      }
    }
  }
}

// With all errors in the model, only noise is left.
TEST(RateTable, LeavesNothingBehindACompleteModel) {
  const auto recording = on_the_table(7, [](double w, double t, double) {
    const double u = w / 3.6e5;
    return w * (5e-4 - 4e-4 * (t - 25)) + 100 * (5 * u * u * u - 3 * u) / 2;
  });
  const Diagnosis diagnosis = diagnosed(
      recording,
      "bias,bias_temperature,scale_factor,scale_factor_temperature,scale_factor_nonlinearity");
  EXPECT_EQ(diagnosis.verdict, Verdict::none);
  EXPECT_LE(diagnosis.residual_rms_dph, 1.2 * kNoiseDph);
}

}  // namespace
