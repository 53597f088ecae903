#include "runs/run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "noise/noise_floor.hpp"
#include "runs/runs.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fogcomp::runs {
namespace {

recording::Recording quiet(std::uint64_t seed) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), fog::test::kQuietNoise, seed);
  recording.file = std::to_string(seed) + ".csv";
  return recording;
}

TEST(Run, FloorsOfSeveralLengths_AreTheRecordings) {
  const recording::Recording recording = quiet(1);
  const runs::Run run = run_of(recording, {10, 60, 10});
  EXPECT_EQ(run.noise_floor_dph(10), noise::noise_floor_dph(recording, 10));
  EXPECT_EQ(run.noise_floor_dph(60), noise::noise_floor_dph(recording, 60));
  EXPECT_FALSE(run.noise_floor_dph(30));
}

TEST(Run, RowsOfAnyLength_AreMadeWithoutReadingAgain) {
  const std::vector<runs::Run> runs{run_of(quiet(1), {10})};
  model::Model model = fog::test::truth();
  const Eigen::Index rows = series_of(model, runs).rows().size();
  model.average_s = 60;
  EXPECT_NEAR(static_cast<double>(series_of(model, runs).rows().size()),
              static_cast<double>(rows) / 6, 1);
}

TEST(Runs, FloorOfTwoRuns_IsTheRmsByLength) {
  Runs runs;
  for (const std::uint64_t seed : {1U, 2U}) runs.training.push_back(run_of(quiet(seed), {10}));
  const double a = *runs.training[0].noise_floor_dph(10);
  const double b = *runs.training[1].noise_floor_dph(10);
  EXPECT_NEAR(*runs.noise_floor_dph(10), std::sqrt((a * a + b * b) / 2), 1e-12);
  EXPECT_FALSE(runs.noise_floor_dph(20));
}

TEST(Runs, WithoutOne_ThatOneIsTheHoldout) {
  Runs runs;
  for (const std::uint64_t seed : {1U, 2U}) runs.training.push_back(run_of(quiet(seed), {10}));
  const Runs others = runs.without(0);
  ASSERT_EQ(others.training.size(), 1U);
  ASSERT_EQ(others.holdouts.size(), 1U);
  EXPECT_EQ(others.training[0].file, "2.csv");
  EXPECT_EQ(others.holdouts[0].file, "1.csv");
  EXPECT_EQ(others.all().size(), 2U);
  EXPECT_TRUE(others.have_several_power_ons());
}

}  // namespace
}  // namespace fogcomp::runs
