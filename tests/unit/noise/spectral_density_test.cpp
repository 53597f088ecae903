#include "noise/spectral_density.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/units.hpp"
#include "unit/compare/slow_noise.hpp"

namespace fogcomp::noise {
namespace {

constexpr double kPeriod = 10;  // s

std::vector<double> white(std::size_t count, double sigma) {
  std::vector<double> values = fog::test::slow_noise(count, 0, 1);
  for (double& value : values) value *= sigma;
  return values;
}

// White noise of one-sided density d has the variance d^2 / (2 period).
TEST(SpectralDensity, OfWhiteNoiseIsLevelAndItsUncertaintyHolds) {
  const std::vector<double> values = white(20000, 3);
  const auto points = spectral_density(values, {{0, values.size()}}, kPeriod);
  ASSERT_GT(points.size(), 20U);
  const double expected = 3 * std::sqrt(2 * kPeriod);
  double chi2 = 0;
  for (const SpectralPoint& point : points) {
    chi2 += std::pow((point.density - expected) / point.one_sigma, 2);
  }
  EXPECT_LT(chi2 / static_cast<double>(points.size()), 2);
  EXPECT_NEAR(points.back().density, expected, 0.1 * expected);
  EXPECT_LE(points.back().frequency_hz, 0.5 / kPeriod);
}

TEST(SpectralDensity, OfAWavePeaksAtItsFrequency) {
  std::vector<double> values(6000);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::sin(2 * kPi * static_cast<double>(i) / 50);
  }
  const auto points = spectral_density(values, {{0, values.size()}}, kPeriod);
  const auto peak = std::max_element(
      points.begin(), points.end(),
      [](const SpectralPoint& a, const SpectralPoint& b) { return a.density < b.density; });
  EXPECT_NEAR(peak->frequency_hz, 1 / (50 * kPeriod), 0.1 / (50 * kPeriod));
}

TEST(SpectralDensity, NeverLooksAcrossAGap) {
  std::vector<double> values = white(4000, 1);
  const auto joined = spectral_density(values, {{0, 4000}}, kPeriod);
  for (std::size_t i = 2000; i < values.size(); ++i) values[i] += 1000;
  const auto parted = spectral_density(values, {{0, 2000}, {2000, 4000}}, kPeriod);
  const auto density = [](const SpectralPoint& a, const SpectralPoint& b) {
    return a.density < b.density;
  };
  const auto largest = [&](const std::vector<SpectralPoint>& points) {
    return std::max_element(points.begin(), points.end(), density)->density;
  };
  EXPECT_LT(largest(parted), 2 * largest(joined));
}

TEST(SpectralDensity, OfTooFewValuesIsEmpty) {
  EXPECT_TRUE(spectral_density(white(18, 1), {{0, 18}}, kPeriod).empty());
  EXPECT_TRUE(spectral_density({}, {}, kPeriod).empty());
}

}  // namespace
}  // namespace fogcomp::noise
