#include "diagnosis/fast_structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/chance.hpp"
#include "unit/fit/made_rows.hpp"

namespace fogcomp::diagnosis {
namespace {

using series::Rows;

constexpr std::size_t kRestRows = 1500;

Rows rest(std::size_t count = kRestRows) {
  return fog::test::made_rows(count, [](double) { return 20; });
}

Eigen::VectorXd white_rows(Eigen::Index count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(count, [&] { return normal(random); });
}

TEST(FastStructure, OfALineHasItsPeriodAndShare) {
  const Rows rows = rest();
  Eigen::VectorXd residual = white_rows(rows.size(), 1);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    residual[i] += 0.7 * std::sin(2 * M_PI * rows.time_s[static_cast<std::size_t>(i)] / 430);
  }
  const FastStructure fast = find_fast_structure(rows, residual);
  EXPECT_NEAR(fast.line_period_s, 430, 430 * 430 / (10.0 * kRestRows));  // one line of the spectrum
  EXPECT_LT(fast.line_log_p, std::log(1e-9));
  EXPECT_NEAR(fast.line_share, 0.245 / 1.245, 0.1);
}

TEST(FastStructure, OfABandIsTheOctaveInWhichItLies) {
  const Rows rows = rest();
  Eigen::VectorXd residual = white_rows(rows.size(), 2);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  // Sinusoids of random phase at periods of 100 to 190 s: an octave, five times as strong as the
  // noise there.
  for (int k = 80; k < 150; ++k) {
    const double a = normal(random);
    const double b = normal(random);
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      const double phase = 2 * M_PI * k * static_cast<double>(i) / kRestRows;
      residual[i] += std::sqrt(10.0 / kRestRows) * (a * std::cos(phase) + b * std::sin(phase));
    }
  }
  const FastStructure fast = find_fast_structure(rows, residual);
  EXPECT_LT(fast.band_log_p, std::log(1e-6));
  EXPECT_GT(fast.band_period_s, 90);
  EXPECT_LT(fast.band_period_s, 210);
  EXPECT_GT(fast.band_excess, 1);
}

TEST(FastStructure, OfWhiteNoiseIsAsRareAsItSays) {
  std::vector<double> lines;
  std::vector<double> bands;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Rows rows = rest();
    const FastStructure fast = find_fast_structure(rows, white_rows(rows.size(), seed));
    lines.push_back(std::exp(fast.line_log_p));
    bands.push_back(std::exp(fast.band_log_p));
  }
  fog::test::expect_chances_are_true(lines);
  fog::test::expect_chances_are_true(bands);
}

TEST(FastStructure, IsLookedForRunByRun) {
  // Two halves of a sinusoid with different phase: the line is found nevertheless.
  Rows rows = rest();
  rows.run_starts = {0, kRestRows / 2};
  Eigen::VectorXd residual = white_rows(rows.size(), 5);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const double turned = i < static_cast<Eigen::Index>(kRestRows / 2) ? 0 : M_PI;
    residual[i] += std::sin(2 * M_PI * static_cast<double>(i) / 43 + turned);
  }
  const FastStructure fast = find_fast_structure(rows, residual);
  EXPECT_NEAR(fast.line_period_s, 430, 30);
  EXPECT_LT(fast.line_log_p, std::log(1e-9));
}

TEST(FastStructure, OfNothingAndOfTooLittleIsNone) {
  for (const std::size_t count : {0U, 1U, 30U, 1500U}) {
    const Rows rows = rest(count);
    const FastStructure fast = find_fast_structure(rows, Eigen::VectorXd::Zero(rows.size()));
    EXPECT_EQ(fast.line_log_p, 0) << count;
    EXPECT_EQ(fast.band_log_p, 0) << count;
    EXPECT_EQ(fast.line_share, 0) << count;
    EXPECT_EQ(fast.band_share, 0) << count;
    EXPECT_TRUE(std::isfinite(fast.line_power)) << count;
  }
}

}  // namespace
}  // namespace fogcomp::diagnosis
