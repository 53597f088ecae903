// Every noise source has the level of its IEEE 952 coefficient, at any row period.
#include "simulation/noise/noise_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fogcomp::simulation {
namespace {

std::vector<double> rows_of(NoiseSource& source, std::size_t rows) {
  std::vector<double> values(rows);
  source.fill(values.data(), rows);
  return values;
}

std::vector<double> block_means(const std::vector<double>& values, std::size_t length) {
  std::vector<double> means;
  for (std::size_t i = 0; i + length <= values.size(); i += length) {
    double sum = 0;
    for (std::size_t j = 0; j < length; ++j) sum += values[i + j];
    means.push_back(sum / static_cast<double>(length));
  }
  return means;
}

double standard_deviation(const std::vector<double>& values) {
  double sum = 0;
  double squares = 0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(values.size());
  return std::sqrt(squares / n - sum * sum / n / n);
}

// Allan deviation of adjacent means of `length` rows.
double allan(const std::vector<double>& values, std::size_t length) {
  const std::vector<double> means = block_means(values, length);
  double squares = 0;
  for (std::size_t i = 1; i < means.size(); ++i) {
    squares += (means[i] - means[i - 1]) * (means[i] - means[i - 1]);
  }
  return std::sqrt(squares / 2 / static_cast<double>(means.size() - 1));
}

TEST(Gaussian, HasTheMomentsAndTailsOfTheNormalLaw) {
  Random random(1, "test");
  constexpr int kCount = 4000000;
  double moments[5] = {};
  int beyond[5] = {};
  for (int i = 0; i < kCount; ++i) {
    const double x = random.gaussian();
    for (int p = 1; p <= 4; ++p) moments[p] += std::pow(x, p) / kCount;
    for (int k = 1; k <= 4; ++k) beyond[k] += std::abs(x) > k ? 1 : 0;
  }
  // Four standard errors each: the moments of powers of a normal variable are known.
  EXPECT_NEAR(moments[1], 0, 4 * std::sqrt(1.0 / kCount));
  EXPECT_NEAR(moments[2], 1, 4 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(moments[3], 0, 4 * std::sqrt(15.0 / kCount));
  EXPECT_NEAR(moments[4], 3, 4 * std::sqrt(96.0 / kCount));
  for (int k = 1; k <= 4; ++k) {
    const double expected = kCount * std::erfc(k / M_SQRT2);
    EXPECT_NEAR(beyond[k], expected, 4 * std::sqrt(expected)) << "beyond " << k << " sigma";
  }
}

TEST(Gaussian, FillsEveryPartOfTheRangeAlike) {
  // Chi-squared over 64 equally probable cells: catches a wrong ziggurat layer.
  Random random(2, "test");
  constexpr int kCells = 64;
  constexpr int kCount = 2000000;
  int counts[kCells] = {};
  for (int i = 0; i < kCount; ++i) {
    const double p = 0.5 * std::erfc(-random.gaussian() / M_SQRT2);
    ++counts[std::min(static_cast<int>(p * kCells), kCells - 1)];
  }
  double chi_squared = 0;
  for (const int count : counts) {
    const double expected = static_cast<double>(kCount) / kCells;
    chi_squared += (count - expected) * (count - expected) / expected;
  }
  EXPECT_LT(chi_squared, 110);  // 63 degrees of freedom: exceeded once in 4000
}

TEST(WhiteNoise, HasTheAngleRandomWalkAtAnyPeriod) {
  for (const double period_s : {0.005, 1.0, 10.0}) {
    WhiteNoise white(0.00124, period_s, 3);
    const double expected_dph = 0.00124 * 60 / std::sqrt(period_s);
    EXPECT_NEAR(standard_deviation(rows_of(white, 100000)), expected_dph, 0.01 * expected_dph);
  }
}

TEST(FlickerNoise, HasItsFloorAt0664TimesTheBiasInstability) {
  // Two million rows of 10 s: the deviation's own error at 10 000 s is 1.6 %.
  FlickerNoise flicker(1, 10, 4);
  const std::vector<double> rows = rows_of(flicker, 2000000);
  for (const std::size_t length : {10U, 30U, 100U, 300U, 1000U}) {
    EXPECT_NEAR(allan(rows, length), 0.664, 0.03) << "at " << 10 * length << " s";
  }
}

TEST(FlickerNoise, IsFlatDownToASecond) {
  FlickerNoise flicker(1, 0.1, 4);
  const std::vector<double> rows = rows_of(flicker, 1000000);
  for (const std::size_t length : {10U, 30U, 100U, 300U}) {
    EXPECT_NEAR(allan(rows, length), 0.664, 0.025) << "at " << length / 10 << " s";
  }
}

TEST(FlickerNoise, OfLongRowsIsTheMeanOfThatOfShortOnes) {
  // Variance and neighbour covariance of 20 s means, made directly and from 0.5 s rows.
  FlickerNoise direct(1, 20, 5);
  FlickerNoise fine(1, 0.5, 6);
  const std::vector<double> long_rows = rows_of(direct, 100000);
  const std::vector<double> short_rows = block_means(rows_of(fine, 4000000), 40);
  for (const std::size_t length : {1U, 2U, 8U}) {
    EXPECT_NEAR(allan(long_rows, length), allan(short_rows, length), 0.02 * 0.664);
  }
}

TEST(RandomWalk, GrowsWithTheSquareRootOfTime) {
  RandomWalk walk(0.5, 10, 7);
  const std::vector<double> rows = rows_of(walk, 2000000);
  for (const std::size_t length : {1U, 10U, 100U}) {
    const double tau_h = 10.0 * static_cast<double>(length) / 3600;
    const double expected = 0.5 * std::sqrt(tau_h / 3);
    EXPECT_NEAR(allan(rows, length), expected, 0.03 * expected);
  }
}

TEST(RateRamp, RisesByItsCoefficientEachHour) {
  RateRamp ramp(0.2, 10);
  const std::vector<double> rows = rows_of(ramp, 361);
  EXPECT_NEAR(rows[360] - rows[0], 0.2, 1e-12);
  EXPECT_NEAR(allan(rows, 90), 0.2 * 0.25 / M_SQRT2, 1e-9);  // R tau / sqrt(2) at 1/4 h
}

TEST(AngleQuantizer, NeverLosesAngleAndHasItsCoefficient) {
  const double q_deg = 1e-5;
  const double period_s = 0.01;
  AngleQuantizer quantizer(q_deg, period_s);
  Random random(8, "test");
  std::vector<double> rate_dph(500000);
  double angle_before = 0;
  for (double& rate : rate_dph) {
    rate = 3 + 20 * random.gaussian();
    angle_before += rate * period_s / 3600;
  }
  std::vector<double> quantized = rate_dph;
  quantizer.apply(quantized.data(), quantized.size());
  double angle_after = 0;
  std::vector<double> error(rate_dph.size());
  for (std::size_t i = 0; i < quantized.size(); ++i) {
    angle_after += quantized[i] * period_s / 3600;
    error[i] = quantized[i] - rate_dph[i];
  }
  EXPECT_NEAR(angle_after, angle_before, 0.5 * std::sqrt(12.0) * q_deg + 1e-9);
  const double expected_dph = std::sqrt(3.0) * q_deg * 3600 / period_s;
  EXPECT_NEAR(allan(error, 1), expected_dph, 0.02 * expected_dph);
}

TEST(Outliers, ComeAsOftenAsAskedAndKeepTheirAngleInLongRows) {
  Outliers fine(30, 4, 0.1, 9);
  Outliers coarse(30, 4, 10, 9);
  const std::vector<double> short_rows = rows_of(fine, 3600000);
  const std::vector<double> long_rows = rows_of(coarse, 36000);
  int hit = 0;
  for (std::size_t i = 0; i < long_rows.size(); ++i) {
    double mean = 0;
    for (std::size_t j = 0; j < 100; ++j) mean += short_rows[100 * i + j] / 100;
    ASSERT_NEAR(long_rows[i], mean, 1e-6);
    hit += long_rows[i] != 0 ? 1 : 0;
  }
  EXPECT_NEAR(hit, 3000, 5 * std::sqrt(3000.0));  // 100 h
}

TEST(Random, GivesEverySourceItsOwnStream) {
  Random white(1, "white");
  Random flicker(1, "flicker");
  Random other_seed(2, "white");
  Random again(1, "white");
  const std::uint64_t first = white.bits();
  EXPECT_NE(first, flicker.bits());
  EXPECT_NE(first, other_seed.bits());
  EXPECT_EQ(first, again.bits());
}

}  // namespace
}  // namespace fogcomp::simulation
