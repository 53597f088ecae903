#include "noise/noise_floor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "unit/compare/noise_generator.hpp"

namespace fogcomp::noise {
namespace {

constexpr double kRateHz = 20;
constexpr double kAverageS = 10;
constexpr double kWalk = 0.00124;  // deg/sqrt(h)
const double kFloorDph = kWalk * 60 / std::sqrt(kAverageS);

recording::Recording record(const compare::NoiseTruth& truth, double hours,
                            std::uint64_t seed = 1) {
  recording::Recording recording;
  const auto rows = static_cast<std::size_t>(hours * 3600 * kRateHz);
  recording.rate_dph = compare::make_noise(truth, rows, 1 / kRateHz, seed);
  for (std::size_t i = 0; i < rows; ++i) {
    recording.time_s.push_back(static_cast<double>(i) / kRateHz);
    recording.temperature_degc.push_back(20);
  }
  recording.period_s = 1 / kRateHz;
  recording.stretch_starts = {0};
  return recording;
}

recording::Recording record_white(double hours, std::uint64_t seed = 1) {
  compare::NoiseTruth truth;
  truth.angle_random_walk_dprh = kWalk;
  return record(truth, hours, seed);
}

void expect_floor(const recording::Recording& recording) {
  const auto floor = noise_floor_dph(recording, kAverageS);
  ASSERT_TRUE(floor.has_value());
  EXPECT_NEAR(*floor / kFloorDph, 1, 0.05);
}

struct Scatter {
  double mean = 0;
  double deviation = 0;
};

/// Of the floor over its truth, of 100 recordings of white noise to which `drift_dph(t)` is added.
template <class Drift>
Scatter scatter(double hours, Drift drift_dph) {
  constexpr int kSeeds = 100;
  double sum = 0;
  double squares = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    recording::Recording recording = record_white(hours, seed);
    for (std::size_t i = 0; i < recording.rows(); ++i) {
      recording.rate_dph[i] += drift_dph(recording.time_s[i]);
    }
    const double ratio = noise_floor_dph(recording, kAverageS).value_or(0) / kFloorDph;
    sum += ratio;
    squares += ratio * ratio;
  }
  const double mean = sum / kSeeds;
  return {mean, std::sqrt(squares / kSeeds - mean * mean)};
}

// A floor is good to 3.3 % with the 360 blocks of an hour and to 10 % in a minute, the mean of a
// hundred to a tenth of that. Bounds are three standard deviations.
TEST(NoiseFloor, IsTheWhiteNoiseOfABlockMeanWhateverTheDrift) {
  const Scatter of_floor =
      scatter(1, [](double t) { return 0.7 + 1e-3 * t + 0.2 * std::sin(t / 300); });
  EXPECT_NEAR(of_floor.mean, 1, 0.01);
  EXPECT_LT(of_floor.deviation, 0.04);
}

TEST(NoiseFloor, IsWithinFivePercentOnALongRecord) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) expect_floor(record_white(5, seed));
}

TEST(NoiseFloor, IsNotFooledBySpikesAndSteps) {
  recording::Recording recording = record_white(5);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    if (i % 9000 == 77) recording.rate_dph[i] += 300;  // 1.5 deg/h in one of 45 block means
    if (i > 100000) recording.rate_dph[i] += 0.5;
    if (i > 200000) recording.rate_dph[i] -= 2;
  }
  expect_floor(recording);
}

TEST(NoiseFloor, IsNotFooledByTheStepsOfTheSensor) {
  recording::Recording recording = record_white(5);
  for (double& rate : recording.rate_dph) rate = std::round(rate / 0.2) * 0.2;
  expect_floor(recording);  // steps of 0.6 sigma of a sample add 1.5 %
}

TEST(NoiseFloor, TakesWhatRemainsOfABrokenRecording) {
  recording::Recording recording = record_white(5);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    recording.time_s[i] += 7 * std::floor(static_cast<double>(i) / 2345);
    if (i > 0 && i % 2345 == 0) recording.stretch_starts.push_back(i);
  }
  expect_floor(recording);
}

TEST(NoiseFloor, OfFlickerNoiseIsThePartBetweenBlocks) {
  compare::NoiseTruth truth;
  truth.bias_instability_dph = 0.01;
  const auto floor = noise_floor_dph(record(truth, 5), kAverageS);
  ASSERT_TRUE(floor.has_value());
  EXPECT_NEAR(*floor, 0.60 * truth.bias_instability_dph, 0.0004);
}

TEST(NoiseFloor, OfAShortRecordingIsJudgedByShorterBlocks) {
  const Scatter of_floor = scatter(1.0 / 60, [](double) { return 0.7; });
  EXPECT_NEAR(of_floor.mean, 1, 0.03);
  EXPECT_LT(of_floor.deviation, 0.125);
}

TEST(NoiseFloor, NeedsThreeRows) {
  recording::Recording recording = record_white(1);
  for (auto* column : {&recording.time_s, &recording.rate_dph}) column->resize(2);
  EXPECT_FALSE(noise_floor_dph(recording, kAverageS).has_value());
  for (auto* column : {&recording.time_s, &recording.rate_dph}) column->resize(1);
  recording.period_s = 0;
  EXPECT_FALSE(noise_floor_dph(recording, kAverageS).has_value());
}

TEST(NoiseFloor, IsZeroForAConstantRate) {
  recording::Recording recording = record_white(0.1);
  recording.rate_dph.assign(recording.rows(), 0.7);
  EXPECT_EQ(noise_floor_dph(recording, kAverageS), 0.0);
}

// In every 27 s there are 2.5 s that are unknown.
TEST(NoiseFloor, LeavesMaskedTimesOut) {
  recording::Recording recording = record_white(5);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double within_s = std::fmod(recording.time_s[i], 27);
    if (within_s < 2) recording.rate_dph[i] += 100;
  }
  for (double t = 0; t < 5 * 3600; t += 27) recording.masks.push_back({"", t - 0.25, t + 2.25});
  expect_floor(recording);
}

// Sweeps of 100 deg/s every 45 s with errors of the scale factor of every kind, each alone ten
// times the noise of a row and more.
TEST(NoiseFloor, KnowsNothingOfTheScaleFactor) {
  recording::Recording recording = record_white(0.7);
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double t = recording.time_s[i];
    const double size = t < 1200 ? 0.3 : 1;
    const double rate = 360000 * size * std::sin(2 * M_PI * t / 45);
    const double degc = 20 + 20 * std::sin(t / 700);
    const double source_degc = 20 + 20 * std::sin((t - 60) / 700);
    recording.temperature_degc[i] = degc;
    recording.input_rate_dph.push_back(rate);
    recording.rate_dph[i] += rate + 2e-6 * rate + 1e-6 * (source_degc - 30) * rate +
                             3 * std::pow(rate / 360000, 3) + 1e-6 * std::fabs(rate) +
                             3.6 * size * std::cos(2 * M_PI * t / 45);
  }
  const auto floor = noise_floor_dph(recording, kAverageS);
  ASSERT_TRUE(floor.has_value());
  EXPECT_NEAR(*floor / kFloorDph, 1, 0.12);
}

}  // namespace
}  // namespace fogcomp::noise
