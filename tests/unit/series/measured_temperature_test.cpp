#include "series/measured_temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fogcomp::series {
namespace {

// Two soaks and a ramp of 0.5 degC/min between, in seconds.
double degc_at(double time_s) {
  constexpr double kRamp_s = 3600;
  constexpr double kPerMinute = 0.5;
  const double ramped_s = std::clamp(time_s - kRamp_s, 0.0, kRamp_s);
  return 20 + kPerMinute * ramped_s / 60;
}

constexpr double kInRamp_s = 5400;
constexpr double kSoak_s = 9900;

recording::Recording read_by(double step_degc, double noise_degc) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  recording::Recording recording;
  recording.period_s = 1;
  recording.stretch_starts = {0};
  for (int i = 0; i < 3 * 3600; ++i) {
    recording.time_s.push_back(i);
    const double degc = degc_at(i) + noise_degc * normal(random);
    recording.temperature_degc.push_back(step_degc > 0 ? step_degc * std::round(degc / step_degc)
                                                       : degc);
    recording.rate_dph.push_back(normal(random));
  }
  return recording;
}

// Rms of the rate's error in the blocks from `first` to before `end`; `rate_at`: of a block, true.
template <class RateAt>
double rms_of_rate_error(const MeasuredTemperature& measured, int first, int end,
                         const RateAt& rate_at) {
  double square = 0;
  for (int i = first; i < end; ++i) {
    square += std::pow(measured.at(i).degc_per_min - rate_at(i), 2);
  }
  return std::sqrt(square / (end - first));
}

// Around a time, away from the corners.
double rate_error(const MeasuredTemperature& measured, double around_s, double degc_per_min) {
  constexpr int kAround = 900;
  const int around = static_cast<int>(around_s);
  return rms_of_rate_error(measured, around - kAround, around + kAround,
                           [&](int) { return degc_per_min; });
}

class MeasuredTemperatureTest : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(MeasuredTemperatureTest, FollowsARampAndASoakThroughStepsAndNoise) {
  const auto [step_degc, noise_degc] = GetParam();
  const MeasuredTemperature measured =
      measured_temperature(make_blocks(read_by(step_degc, noise_degc)));
  EXPECT_NEAR(measured.at(static_cast<int>(kInRamp_s)).degc, degc_at(kInRamp_s),
              0.2 * (step_degc + noise_degc));
  EXPECT_LT(rate_error(measured, kInRamp_s, 0.5), 0.02);
  // Within one step of 1 degC nothing tells where the temperature is.
  EXPECT_LT(rate_error(measured, kSoak_s, 0), std::max(0.05, 0.5 * step_degc));
  EXPECT_DOUBLE_EQ(measured.thermometer.resolution_degc, step_degc);
}

INSTANTIATE_TEST_SUITE_P(Thermometers, MeasuredTemperatureTest,
                         testing::Values(std::pair{1.0, 0.05}, std::pair{0.25, 0.05},
                                         std::pair{0.0625, 0.03}, std::pair{0.00390625, 0.004}));

// A coil that follows a chamber at 1 degC/min by 120 s, and its true temperature rates.
struct InAChamber {
  recording::Recording recording;
  std::vector<double> rates;

  InAChamber(double step_degc, double soak_s) {
    constexpr double kPerMinute = 1;
    constexpr double kLag_s = 120;
    recording.period_s = 1;
    recording.stretch_starts = {0};
    double chamber = 25;
    double coil = chamber;
    for (const double target : {60.0, 0.0, -30.0, 25.0}) {
      const double ramp_s = std::abs(target - chamber) / kPerMinute * 60;
      const double from = chamber;
      for (int i = 0; i < ramp_s + soak_s; ++i) {
        chamber = from + std::min(1.0, i / ramp_s) * (target - from);
        rates.push_back(60 * (chamber - coil) / kLag_s);
        recording.time_s.push_back(static_cast<double>(recording.time_s.size()));
        recording.temperature_degc.push_back(std::round(coil / step_degc) * step_degc);
        recording.rate_dph.push_back(0);
        coil += (chamber - coil) / kLag_s;
      }
    }
  }

  double rate_error() const {
    return rms_of_rate_error(measured_temperature(make_blocks(recording)), 0,
                             static_cast<int>(rates.size()),
                             [&](int i) { return rates[static_cast<std::size_t>(i)]; });
  }
};

TEST(MeasuredTemperature, NoiselessSteps_HaveTheRateOfTheRamps) {
  EXPECT_LT(InAChamber(0.0625, 900).rate_error(), 0.02);
  EXPECT_LT(InAChamber(0.5, 900).rate_error(), 0.05);
}

// Thousands of readings that say the same, between two edges that are never met.
TEST(MeasuredTemperature, NoiselessSteps_DoNotWanderInALongSoak) {
  EXPECT_LT(InAChamber(0.5, 5400).rate_error(), 0.03);
  EXPECT_LT(InAChamber(1, 5400).rate_error(), 0.05);
}

TEST(MeasuredTemperature, WrongReadings_SayNothing) {
  InAChamber gyro(0.01, 900);
  const double without = gyro.rate_error();
  gyro.recording.temperature_degc.front() += 1.5;
  gyro.recording.temperature_degc[5000] -= 1.8;
  gyro.recording.temperature_degc.back() -= 1.2;
  EXPECT_LT(gyro.rate_error(), 1.2 * without);
}

// To `step_degc` in rows `next()` apart, and on lines between, which are no readings.
template <class Next>
recording::Recording read_now_and_then(double step_degc, const Next& next) {
  recording::Recording recording = read_by(0, 0);
  recording.temperature_period_s = 300;
  recording.temperature_step_degc = step_degc;
  recording.temperature_is_read.resize(recording.rows());
  const auto reading = [&](std::size_t row) {
    return step_degc * std::round(degc_at(static_cast<double>(row)) / step_degc);
  };
  for (std::size_t row = 0; row < recording.rows();) {
    const std::size_t end = row + next();
    recording.temperature_is_read[row] = true;
    for (std::size_t i = row; i < std::min(end, recording.rows()); ++i) {
      const double part = static_cast<double>(i - row) / static_cast<double>(end - row);
      recording.temperature_degc[i] = (1 - part) * reading(row) + part * reading(end);
    }
    row = end;
  }
  return recording;
}

TEST(MeasuredTemperature, SlowCoarseReadings_RateOfTheRamp) {
  const MeasuredTemperature measured =
      measured_temperature(make_blocks(read_now_and_then(1, [] { return std::size_t{300}; })));
  EXPECT_LT(rate_error(measured, kInRamp_s, 0.5), 0.02);
  EXPECT_LT(rate_error(measured, kSoak_s, 0), 0.05);
}

TEST(MeasuredTemperature, ReadingsThatComeUnevenly_RateOfTheRamp) {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> next(5, 90);
  const MeasuredTemperature measured =
      measured_temperature(make_blocks(read_now_and_then(1e-4, [&] { return next(random); })));
  EXPECT_LT(rate_error(measured, kInRamp_s, 0.5), 0.002);
  EXPECT_LT(rate_error(measured, kSoak_s, 0), 0.002);
}

// 30 degC about 20 in rows of 10 s, without noise.
recording::Recording up_and_down() {
  recording::Recording recording;
  recording.period_s = 10;
  recording.stretch_starts = {0};
  for (int i = 0; i < 1500; ++i) {
    recording.time_s.push_back(10 * i);
    recording.temperature_degc.push_back(20 + 30 * std::sin(i / 200.0));
    recording.rate_dph.push_back(0);
  }
  return recording;
}

double rate_up_and_down(int block) {
  return 30 * std::cos(block / 200.0) / 200 * 6;
}

// Nearly all of what is known of the rate at first goes with the first readings.
TEST(MeasuredTemperature, KeepsItsDigitsWithoutNoise) {
  const MeasuredTemperature measured = measured_temperature(make_blocks(up_and_down()));
  EXPECT_LT(rms_of_rate_error(measured, 0, 1500, rate_up_and_down), 1e-4);
}

TEST(MeasuredTemperature, ThatWasComputed_IsItsReadings) {
  const BlockSeries series = with_exact_temperature(make_blocks(up_and_down()));
  EXPECT_EQ(series.temperature->at(700).degc, series.blocks[700].means.temperature);
  EXPECT_LT(rms_of_rate_error(*series.temperature, 1, 1499, rate_up_and_down), 1e-5);
}

TEST(MeasuredTemperature, ThatWasComputed_HasAValueForEachBlockOfAGap) {
  BlockSeries series = make_blocks(up_and_down());
  series.blocks.erase(series.blocks.begin() + 701, series.blocks.begin() + 703);
  series = with_exact_temperature(std::move(series));
  ASSERT_EQ(series.temperature->parts.size(), 1U);
  EXPECT_EQ(series.temperature->at(703).degc, series.blocks[701].means.temperature);
}

// A turn is not rounded for the sake of long soaks, nor do soaks wander because there are turns.
TEST(MeasuredTemperature, FollowsATurnBetweenLongSoaks) {
  recording::Recording recording = read_by(0.0625, 0.03);
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  constexpr int kTurn = 2 * 3600;
  constexpr double kLag_s = 60;
  std::vector<double> rates;
  for (std::size_t i = 0; i < recording.rows(); ++i) {
    const double since_s = static_cast<double>(i) - kTurn;
    const double jump_degc =
        since_s > 0 ? 10 * (1 - (1 + since_s / kLag_s) * std::exp(-since_s / kLag_s)) : 0;
    const double degc = 20 + jump_degc + 0.03 * normal(random);
    recording.temperature_degc[i] = 0.0625 * std::round(degc / 0.0625);
    rates.push_back(since_s > 0 ? 600 * since_s / kLag_s / kLag_s * std::exp(-since_s / kLag_s)
                                : 0);
  }
  const MeasuredTemperature measured = measured_temperature(make_blocks(recording));
  const auto error = [&](int first, int end) {
    return rms_of_rate_error(measured, first, end,
                             [&](int i) { return rates[static_cast<std::size_t>(i)]; });
  };
  EXPECT_LT(error(kTurn - 60, kTurn + 300), 0.06) << "of at most 3.7 degC/min";
  EXPECT_LT(error(600, kTurn - 600), 0.014);
}

TEST(MeasuredTemperature, HasAValueForEachBlockOfAGap) {
  recording::Recording recording = read_by(0.25, 0.05);
  const auto drop = [](std::vector<double>& column) {
    column.erase(column.begin() + 5000, column.begin() + 5020);
  };
  drop(recording.time_s);
  drop(recording.temperature_degc);
  drop(recording.rate_dph);
  recording.stretch_starts = {0, 5000};
  const MeasuredTemperature measured = measured_temperature(make_blocks(recording));
  ASSERT_EQ(measured.parts.size(), 1U);
  EXPECT_NEAR(measured.at(5010).degc, degc_at(5010), 0.1);
}

TEST(MeasuredTemperature, IsThatOfAReadingThatNeverChanges) {
  recording::Recording recording = read_by(0, 0);
  for (double& degc : recording.temperature_degc) degc = 25;
  const MeasuredTemperature measured = measured_temperature(make_blocks(recording));
  EXPECT_NEAR(measured.at(4000).degc, 25, 1e-3);
  EXPECT_NEAR(measured.at(4000).degc_per_min, 0, 1e-3);
}

}  // namespace
}  // namespace fogcomp::series
