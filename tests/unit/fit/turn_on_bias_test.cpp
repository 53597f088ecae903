#include "fit/turn_on_bias.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "model/effect_list.hpp"
#include "recording/reading.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::fit {
namespace {

// Two runs of one gyro in rows of a minute, the second one with a higher bias.
std::vector<runs::Run> two_runs(std::uint64_t seed, double above_dph) {
  std::vector<runs::Run> runs;
  for (const double bias_dph : {0.0, above_dph}) {
    recording::Recording recording = fog::test::thinned(
        fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, seed++), 6);
    recording.file = runs.empty() ? "first.csv" : "second.csv";
    for (double& rate_dph : recording.rate_dph) rate_dph += bias_dph;
    runs.push_back(runs::run_of(recording, {60}));
  }
  return runs;
}

model::Model in_minutes(model::Model model) {
  model.average_s = 60;
  return model;
}

TEST(TurnOnBias, OfTwoRunsIsSaidWithItsUncertainty) {
  const auto found = turn_on_biases(in_minutes(fog::test::truth()), two_runs(1, 0.12)).biases;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].certain);
  EXPECT_EQ(found[0].run, "second.csv");
  EXPECT_EQ(found[0].reference, "first.csv");
  EXPECT_NEAR(found[0].above_dph, 0.12, 3 * found[0].sigma_dph);
  EXPECT_LT(found[0].sigma_dph, 0.02);
}

TEST(TurnOnBias, IsHardlyEverSaidOfRunsThatDifferByNoise) {
  int said = 0;
  for (std::uint64_t seed = 1; seed <= 80; seed += 2) {
    said +=
        turn_on_biases(in_minutes(fog::test::truth()), two_runs(seed, 0)).biases[0].certain ? 1 : 0;
  }
  EXPECT_LE(said, 3);  // of 40, at 1 %
}

// Runs at one temperature each, in rows of a minute, with a slope in temperature and biases of
// +-`above_dph` in turn.
std::vector<runs::Run> static_runs(double above_dph) {
  std::vector<runs::Run> runs;
  for (std::uint64_t i = 0; i < 6; ++i) {
    recording::Recording run =
        fog::test::thinned(fog::test::static_recording(20.0 * static_cast<double>(i) - 40, 0.0005,
                                                       fog::test::kQuietNoise, 1 + i),
                           6);
    for (std::size_t row = 0; row < run.rows(); ++row)
      run.rate_dph[row] += above_dph * (i % 2 == 0 ? 1 : -1) + 0.01 * run.temperature_degc[row];
    run.file = std::to_string(i) + ".csv";
    runs.push_back(runs::run_of(run, {60}));
  }
  return runs;
}

// Runs at one temperature each, with biases of their own: their drift with temperature cannot be
// told from the biases, and that is said.
TEST(TurnOnBias, OfRunsAtOneTemperatureEachIsSaidOfAllTogether) {
  for (const double repeatability_dph : {0.0, 0.3}) {
    const compare::TurnOn found = turn_on_biases(
        in_minutes(fog::test::model_of(model::parse_effects("bias,bias_temperature:order=1"))),
        static_runs(repeatability_dph));
    ASSERT_EQ(found.biases.size(), 5U);
    EXPECT_EQ(found.first_certain(), nullptr);
    EXPECT_EQ(found.differs, repeatability_dph > 0);
    EXPECT_NEAR(found.repeatability_dph, repeatability_dph, 0.15);
  }
}

TEST(TurnOnBias, IsNotSaidOfADriftThatTheModelLacks) {
  const model::Model lacking =
      in_minutes(fog::test::model_of(model::parse_effects("bias,bias_temperature")));
  std::vector<runs::Run> runs = two_runs(1, 0);
  // The second run is only the first ramp: the missing part of the model is a constant there.
  const auto ramp = runs[1].blocks.blocks.begin() + 60;
  runs[1].blocks.blocks.erase(ramp + 80, runs[1].blocks.blocks.end());
  runs[1].blocks.blocks.erase(runs[1].blocks.blocks.begin(), ramp);
  const auto found = turn_on_biases(lacking, runs).biases;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].certain) << found[0].above_dph << " +- " << found[0].sigma_dph;
  EXPECT_GT(std::abs(found[0].above_dph), 0.02);  // which noise alone would not make
}

// A model of a bias alone, and what the drift does with temperature lies between the runs.
TEST(TurnOnBias, IsNotSaidOfADriftWithTemperatureThatTheModelLacks) {
  const compare::TurnOn found =
      turn_on_biases(in_minutes(fog::test::model_of(model::parse_effects("bias"))), static_runs(0));
  EXPECT_EQ(found.first_certain(), nullptr);
  EXPECT_TRUE(found.differs);
}

// The power is off at the end of the first half.
TEST(TurnOnBias, WithinARunIsSaidWithItsTime) {
  recording::Recording recording =
      fog::test::thinned(fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, 1), 6);
  recording.file = "twice.csv";
  const std::size_t restart = recording.rows() / 2;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const double on_s = recording.time_s[row < restart ? 0 : restart];
    recording.uptime_s.push_back(recording.time_s[row] - on_s);
    if (row >= restart) recording.rate_dph[row] -= 0.12;
  }
  recording::find_stretches(recording);
  const auto found =
      turn_on_biases(in_minutes(fog::test::truth()), {runs::run_of(recording, {60})}).biases;
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].certain);
  EXPECT_NEAR(found[0].from_s, recording.time_s[restart], 60);
  EXPECT_NEAR(found[0].above_dph, -0.12, 3 * found[0].sigma_dph);
}

TEST(TurnOnBias, OfOneRunIsNotAsked) {
  std::vector<runs::Run> runs = two_runs(1, 0.12);
  runs.pop_back();
  EXPECT_TRUE(turn_on_biases(in_minutes(fog::test::truth()), runs).biases.empty());
}

}  // namespace
}  // namespace fogcomp::fit
