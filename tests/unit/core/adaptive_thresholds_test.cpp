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

// Stein's unbiased estimate of the risk, in noise variances, with all details at hand.
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
      double least = risk(details, kUniversal);
      for (int k = 1; k < 16; ++k) least = std::min(least, risk(details, k * (kUniversal / 16.0)));
      const double chosen = risk(details, kUniversal * histogram.sixteenths() / 16.0);
      // The details' squares are known to the width of a bin only: 2 % of the noise in the block.
      ASSERT_LE(chosen - least, 0.02 * fog::kThresholdBlock) << strength;
    }
  }
}

TEST(RiskHistogram, TakesAnyMagnitude) {
  fog::RiskHistogram histogram;
  while (!histogram.full()) histogram.add(0xFFFFFFFFU, 32767);
  histogram.choose();
  EXPECT_LE(histogram.sixteenths(), fog::RiskHistogram::kWhole);
  histogram.add(5, 0);  // no threshold, nothing to choose
  EXPECT_FALSE(histogram.full());
}

TEST(NoiseGain, FindsTheNoiseInSpiteOfOutliers) {
  for (const double factor : {0.05, 1.0, 3.5}) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0, 1000 * factor);
    fog::NoiseGain gain;
    for (int i = 0; i < 8000; ++i) {
      gain.follow(i % 50 == 0 ? 0xFFFFFFFFU : magnitude(noise(random)), kUniversal);
    }
    double mean = 0;
    constexpr int kSamples = 8000;
    for (int i = 0; i < kSamples; ++i) {
      gain.follow(i % 50 == 0 ? 0xFFFFFFFFU : magnitude(noise(random)), kUniversal);
      mean += std::ldexp(gain.raw(), -fog::NoiseGain::kFraction) / kSamples;
    }
    EXPECT_NEAR(mean / factor, 1, 0.06) << factor;
  }
}

TEST(NoiseGain, StaysWithinItsLimits) {
  fog::NoiseGain gain;
  for (int i = 0; i < 100000; ++i) gain.follow(0xFFFFFFFFU, kUniversal);
  EXPECT_EQ(gain.raw(), fog::NoiseGain::kMost);
  for (int i = 0; i < 100000; ++i) gain.follow(0, kUniversal);
  EXPECT_GE(gain.raw(), 512U);
}

}  // namespace
