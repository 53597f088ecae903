// An input rate that was recorded less often than the gyro's rate.

#include "recording/reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace fogcomp::recording {
namespace {

constexpr double kSampleS = 0.1;
constexpr std::size_t kSamples = 12000;
constexpr double kWhiteNoiseDph = 20;
constexpr double kAmplitudeDph = 3600 * 40;

double sine(double time_s) {
  return kAmplitudeDph * std::sin(2 * M_PI * time_s / 20);
}
// A table that steps every 31.3 s.
double steps(double time_s) {
  return 36000 * std::fmod(std::floor(time_s / 31.3), 3);
}

struct Record {
  std::vector<double> time_s;
  std::vector<double> rate_dph;  // a gyro's
  std::vector<double> input_rate;

  std::vector<Mask> complete() {
    std::vector<Mask> unknown = draw_input_rate(time_s, rate_dph, input_rate);
    join_by_lines(time_s, input_rate);
    return unknown;
  }
  bool blank_held() { return blank_held_readings(time_s, rate_dph, input_rate); }
};

Record record_of(const std::function<double(double)>& movement) {
  Record record;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (std::size_t row = 0; row < kSamples; ++row) {
    const double time_s = static_cast<double>(row) * kSampleS;
    record.time_s.push_back(time_s);
    record.input_rate.push_back(movement(time_s));
    record.rate_dph.push_back(movement(time_s) + kWhiteNoiseDph * normal(random));
  }
  return record;
}

Record with_one_reading_in(std::size_t one_in, Record record) {
  for (std::size_t row = 0; row < kSamples; ++row) {
    if (row % one_in != 0) record.input_rate[row] = std::numeric_limits<double>::quiet_NaN();
  }
  return record;
}

// Each reading repeated until the next one, which comes after `next(row)` rows.
Record held(const std::function<std::size_t(std::size_t)>& next, Record record) {
  std::size_t reading = 0;
  for (std::size_t row = 0; row < kSamples; ++row) {
    if (row - reading >= next(reading)) reading = row;
    record.input_rate[row] = record.input_rate[reading];
  }
  return record;
}

double covered_s(const std::vector<Mask>& masks) {
  double sum = 0;
  for (const Mask& mask : masks) sum += mask.to_s - mask.from_s;
  return sum;
}

TEST(SparseInputRate, OfASmoothMovementLosesNoneOfIt) {
  Record record = with_one_reading_in(10, record_of(sine));
  EXPECT_TRUE(record.complete().empty());
  double product = 0;
  double square = 0;
  for (std::size_t row = 0; row + 10 < kSamples; ++row) {
    product += record.input_rate[row] * sine(record.time_s[row]);
    square += std::pow(sine(record.time_s[row]), 2);
  }
  // 1 - 11/720 (2 pi / 20)^4; straight lines: 1 - (2 pi / 20)^2 / 12 = 0.992.
  EXPECT_NEAR(product / square, 1, 2e-4);
}

TEST(SparseInputRate, IsUnknownBetweenReadingsWhereItSteps) {
  Record record = with_one_reading_in(10, record_of(steps));
  const std::vector<Mask> unknown = record.complete();
  ASSERT_EQ(unknown.size(), 38U);  // 1200 s / 31.3 s
  for (const Mask& mask : unknown) {
    const double at_s = std::ceil(mask.from_s / 31.3) * 31.3;
    EXPECT_TRUE(mask.from_s <= at_s && at_s <= mask.to_s) << mask.from_s;
    EXPECT_NEAR(mask.to_s - mask.from_s, 1, 1e-9);
  }
  const std::vector<bool> masked = covered(unknown, record.time_s);
  for (std::size_t row = 0; row < kSamples; ++row) {
    const double time_s = record.time_s[row];
    if (masked[row]) continue;
    EXPECT_NEAR(record.input_rate[row], steps(time_s), 1e-6) << time_s;
  }
}

// From 10 to -10 deg/s at an even acceleration: the readings at its ends and in its middle lie on
// one cubic, which none of the others does.
TEST(SparseInputRate, IsUnknownAtTheCornersOfAReversal) {
  Record record = with_one_reading_in(10, record_of([](double time_s) {
                                        return 36000 * std::clamp((601 - time_s) / 1.09, -1.0, 1.0);
                                      }));
  const std::vector<Mask> unknown = record.complete();
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_EQ(unknown[0].from_s, 599);
  EXPECT_EQ(unknown[0].to_s, 603);
}

TEST(SparseInputRate, IsAsGoodAsItsReadings) {
  Record record = record_of(sine);
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (double& value : record.input_rate) value += 50 * kWhiteNoiseDph * normal(random);
  EXPECT_LT(covered_s(with_one_reading_in(10, record).complete()), 3);
}

TEST(SparseInputRate, OfFewReadingsIsAStraightLine) {
  Record record = record_of([](double time_s) { return time_s; });
  for (std::size_t row = 0; row < kSamples; ++row) {
    if (row % 300 != 0 || row > 900) {
      record.input_rate[row] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  EXPECT_TRUE(record.complete().empty());
  EXPECT_NEAR(record.input_rate[450], 45, 1e-9);
  EXPECT_EQ(record.input_rate[1400], record.input_rate[900]);  // repeated for a minute
  EXPECT_TRUE(std::isnan(record.input_rate[1600]));
}

TEST(SparseInputRate, MayBeHeldFromReadingToReading) {
  const auto every_ten = [](std::size_t) { return std::size_t{10}; };
  // A log with a clock of its own.
  const auto ten_or_eleven = [](std::size_t row) { return std::size_t{10 + row % 2}; };
  for (const auto& next : {std::function<std::size_t(std::size_t)>(every_ten),
                           std::function<std::size_t(std::size_t)>(ten_or_eleven)}) {
    Record record = held(next, record_of(sine));
    ASSERT_TRUE(record.blank_held());
    EXPECT_LT(covered_s(record.complete()), 3);
    EXPECT_NEAR(record.input_rate[6005], sine(record.time_s[6005]), 0.001 * kAmplitudeDph);
  }
}

TEST(SparseInputRate, IsNotHeldWhereTheGyroStepsWithItOrItMovesAlways) {
  for (const auto& movement : {steps, sine}) {
    Record record = record_of(movement);
    const std::vector<double> before = record.input_rate;
    EXPECT_FALSE(record.blank_held());
    EXPECT_EQ(record.input_rate, before);
  }
  Record constant = record_of([](double) { return 15.0; });
  EXPECT_FALSE(constant.blank_held());
}

}  // namespace
}  // namespace fogcomp::recording
