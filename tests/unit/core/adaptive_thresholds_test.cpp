#include "core/denoise/adaptive_thresholds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

constexpr std::uint32_t kUniversal = 3115;  // 3.115 standard deviations of 1000

std::uint32_t magnitude(double value) {
  return static_cast<std::uint32_t>(std::lround(std::abs(value)));
}

// Stein's unbiased risk estimate, in noise variances, from all details.
double risk(const std::vector<double>& details, double threshold) {
  double sum = 0;
  for (const double detail : details) {
    const double square = detail * detail / 1e6;
    const double limit = threshold * threshold / 1e6;
    sum += std::min(square, limit) - (std::abs(detail) <= threshold ? 2 : 0);
  }
  return sum;
}

TEST(RiskHistogram, KeepsTheUniversalThresholdWhereThereIsNoSignal) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 1000);
  fog::RiskHistogram histogram;
  for (int block = 0; block < 200; ++block) {
    while (!histogram.full()) histogram.add(magnitude(normal(random)), kUniversal);
    histogram.choose();
    ASSERT_EQ(histogram.sixteenths(), fog::RiskHistogram::kWhole);
  }
}

TEST(RiskHistogram, ChoosesTheCandidateOfLeastRiskWhereTheSignalIsStrong) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 1000);
  for (const double strength : {2000.0, 3000.0, 8000.0, 50000.0}) {
    std::normal_distribution<double> signal(0, strength);
    for (int block = 0; block < 50; ++block) {
      fog::RiskHistogram histogram;
      std::vector<double> details;
      while (!histogram.full()) {
        details.push_back(signal(random) + noise(random));
        histogram.add(magnitude(details.back()), kUniversal);
      }
      histogram.choose();
      double min = risk(details, kUniversal);
      for (int k = 1; k < 16; ++k) min = std::min(min, risk(details, k * (kUniversal / 16.0)));
      const double chosen = risk(details, kUniversal * histogram.sixteenths() / 16.0);
      // The squares of the details are known to a bin's width only: 2 % of the noise in the block.
      ASSERT_LE(chosen - min, 0.02 * fog::kThresholdBlock) << strength;
    }
  }
}

// 64 details of one size and 64 of another, in 64ths of the universal threshold: which candidate is
// best is then a matter of one bin.
std::uint32_t chosen(std::uint32_t small, std::uint32_t large, std::uint32_t unit = 10) {
  fog::RiskHistogram histogram;
  for (int i = 0; i < 64; ++i) {
    histogram.add(small * unit, 64 * unit);
    histogram.add(large * unit, 64 * unit);
  }
  EXPECT_TRUE(histogram.choose());
  return histogram.sixteenths();
}

TEST(RiskHistogram, BinsAreSixteenthsOfTheUniversalThreshold) {
  // Small details are noise, best removed by a threshold just above them (a larger one would remove
  // signal).
  for (std::uint32_t bin = 1; bin < 5; ++bin) {
    EXPECT_EQ(chosen(4 * bin, 1000), bin + 1);
    EXPECT_EQ(chosen(4 * bin - 1, 1000), bin);
    EXPECT_EQ(chosen(4 * bin, 1000, 511), bin + 1);
  }
  EXPECT_EQ(chosen(0, 1000), 1U);
}

// In units of 16 / 64 of the threshold, squared: one detail counts at most (4 * 4)^2 = 256, and the
// signal is weak below 557.
TEST(RiskHistogram, ASignalIsWeakBelowItsLimitOfEnergy) {
  const auto weak = [](std::uint32_t magnitude, int times, int units) {
    fog::RiskHistogram histogram;
    for (int i = 0; i < times; ++i) histogram.add(magnitude, 640);
    for (int i = 0; i < units; ++i) histogram.add(160, 640);
    while (!histogram.full()) histogram.add(0, 640);
    histogram.choose();
    return histogram.sixteenths() == fog::RiskHistogram::kWhole;
  };
  for (const std::uint32_t large : {2560U, 5000U, 0xFFFFFFFFU}) {
    EXPECT_TRUE(weak(large, 2, 556 - 512));
    EXPECT_FALSE(weak(large, 2, 557 - 512));
  }
  EXPECT_TRUE(weak(2549, 2, 556 - 504));  // 254^2 / 256 = 252
  EXPECT_FALSE(weak(2549, 2, 557 - 504));
}

TEST(RiskHistogram, TakesAnyMagnitude) {
  fog::RiskHistogram histogram;
  while (!histogram.full()) histogram.add(0xFFFFFFFFU, 32767);
  histogram.choose();
  EXPECT_LE(histogram.sixteenths(), fog::RiskHistogram::kWhole);
  histogram.add(5, 0);  // no threshold, nothing to choose
  EXPECT_FALSE(histogram.full());
}

// What it makes of 1, with kFraction fractional bits.
std::uint32_t gain_of(const fog::NoiseScale& gain) {
  return gain.of(std::uint32_t{1} << fog::NoiseScale::kFraction);
}

TEST(NoiseScale, FindsTheNoiseInSpiteOfOutliers) {
  for (const double factor : {0.05, 1.0, 3.5}) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 1000 * factor);
    fog::NoiseScale gain;
    for (int i = 0; i < 8000; ++i) {
      gain.follow(i % 50 == 0 ? 0xFFFFFFFFU : magnitude(noise(random)), kUniversal);
    }
    double mean = 0;
    constexpr int kSamples = 8000;
    for (int i = 0; i < kSamples; ++i) {
      gain.follow(i % 50 == 0 ? 0xFFFFFFFFU : magnitude(noise(random)), kUniversal);
      mean += std::ldexp(gain_of(gain), -fog::NoiseScale::kFraction) / kSamples;
    }
    EXPECT_NEAR(mean / factor, 1, 0.06) << factor;
  }
}

TEST(NoiseScale, StaysWithinItsLimits) {
  fog::NoiseScale gain;
  for (int i = 0; i < 100000; ++i) gain.follow(0xFFFFFFFFU, kUniversal);
  EXPECT_EQ(gain_of(gain), fog::NoiseScale::kMax);
  for (int i = 0; i < 100000; ++i) gain.follow(0, kUniversal);
  EXPECT_GE(gain_of(gain), 512U);
}

}  // namespace
