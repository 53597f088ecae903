#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "identification/effect_list.hpp"
#include "identification/identify.hpp"
#include "support/input_error.hpp"
#include "unit/identification/simulated_gyro.hpp"

namespace {

using fog::test::truth;
using fogcomp::Model;

constexpr double kWhiteDph = 0.024;

// White noise, and flicker noise as components an octave and a half apart.
fogcomp::Recording noisy_recording(std::uint64_t seed) {
  fogcomp::Recording recording = fog::test::recording_of(truth(), {kWhiteDph, 0, 300}, seed);
  std::mt19937_64 random(seed + 1000);
  std::normal_distribution<double> normal;
  for (double tau_s = 30; tau_s < 20000; tau_s *= 3) {
    const double decay = std::exp(-10 / tau_s);
    double slow = 0.003 * normal(random);
    for (double& rate : recording.rate_dph) {
      rate += slow;
      slow = decay * slow + 0.003 * std::sqrt(1 - decay * decay) * normal(random);
    }
  }
  return recording;
}

void add_step(fogcomp::Recording& recording, double at_s, double size_dph) {
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    if (recording.time_s[i] >= at_s) recording.rate_dph[i] += size_dph;
  }
}

struct Result {
  Model model;
  fogcomp::Identification identified;
};

Result fit(const std::vector<fogcomp::Recording>& recordings, const std::string& effects) {
  Result result{truth(), {}};
  result.model.terms = fogcomp::parse_effects(effects);
  fogcomp::SignalSeries series(result.model);
  for (const auto& recording : recordings) series.add(fogcomp::make_blocks(recording));
  result.identified = fogcomp::identify(result.model, series);
  return result;
}

const char* const kEffects = "bias,bias_temperature:order=3,temperature_rate,bias_step";

TEST(BiasSteps, AreNotFoundInWhiteAndFlickerNoise) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Result result = fit({noisy_recording(seed)}, kEffects);
    found += result.identified.steps.empty() ? 0 : 1;
  }
  std::printf("steps found in %d of 100 recordings without one\n", found);
  EXPECT_LE(found, 2);
}

TEST(BiasSteps, OfFiveSigmaOfARowAreFoundToWithinAFewRows) {
  int found = 0;
  int covered = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    fogcomp::Recording recording = noisy_recording(seed);
    const double at_s = 4000 + 1300 * static_cast<double>(seed);
    const double size_dph = (seed % 2 == 0 ? 5 : -5) * kWhiteDph;
    add_step(recording, at_s, size_dph);
    const Result result = fit({recording}, kEffects);
    if (result.identified.steps.size() != 1) continue;
    ++found;
    const fogcomp::FoundStep& step = result.identified.steps[0];
    EXPECT_NEAR(step.time_s, at_s, 30) << seed;
    EXPECT_LT(step.time_sigma_s, 20) << seed;
    covered += std::abs(step.size_dph - size_dph) <= 1.96 * step.size_sigma_dph ? 1 : 0;
    EXPECT_GE(result.identified.masked, 1U);
    // The step is a term of the model, and the others are what they are without it.
    EXPECT_STREQ(result.model.terms.back().name.c_str(), "bias_step");
    EXPECT_EQ(result.model.terms.back().parameters[0], step.time_s);
    EXPECT_NEAR(result.model.terms[2].coefficients_dph[0], 0.44,
                4 * result.model.terms[2].sigma_dph[0]);
  }
  std::printf("found %d of 20; the size within its 95 %% interval in %d\n", found, covered);
  EXPECT_GE(found, 19);
  EXPECT_GE(covered, 16);
}

TEST(BiasSteps, SeveralAreFoundAndAWildRowIsNone) {
  fogcomp::Recording recording = noisy_recording(3);
  add_step(recording, 9000, 0.15);
  add_step(recording, 21000, -0.2);
  add_step(recording, 30000, 0.1);
  recording.rate_dph[1500] += 30;
  const Result result = fit({recording}, kEffects);
  ASSERT_EQ(result.identified.steps.size(), 3U);
  double sum = 0;
  for (const fogcomp::FoundStep& step : result.identified.steps) sum += step.size_dph;
  EXPECT_NEAR(sum, 0.05, 0.03);
}

TEST(BiasSteps, BelongToTheRecordingInWhichTheyLie) {
  fogcomp::Recording second = noisy_recording(5);
  add_step(second, 15000, 0.2);
  const Result result = fit({noisy_recording(4), second}, kEffects);
  ASSERT_EQ(result.identified.steps.size(), 1U);
  EXPECT_EQ(result.identified.steps[0].run, 1U);
  EXPECT_NEAR(result.identified.steps[0].time_s, 15000, 20);
  EXPECT_NEAR(result.identified.steps[0].size_dph, 0.2, 0.02);
}

TEST(BiasSteps, WithATimeAreNotSearchedForAndAloneAreRefused) {
  fogcomp::Recording recording = noisy_recording(6);
  add_step(recording, 15000, 0.2);
  const Result given = fit({recording}, "bias,bias_temperature,bias_step:at=15000");
  EXPECT_TRUE(given.identified.steps.empty());
  EXPECT_NEAR(given.model.terms.back().coefficients_dph[0], 0.2, 0.05);
  EXPECT_THROW(fit({recording}, "bias_step"), fogcomp::InputError);
}

}  // namespace
