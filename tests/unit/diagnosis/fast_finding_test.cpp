#include "diagnosis/fast_finding.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "diagnosis/decision_rules.hpp"
#include "support/units.hpp"
#include "unit/diagnosis/made_evidence.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kRowNoise_dph = 0.024;

// Gyro of white noise with `more` added to each row's rate.
FastFinding found_with(const std::function<double(double)>& more) {
  recording::Recording recording =
      fog::test::recording_of(fog::test::truth(), {kRowNoise_dph, 0, 600}, 1);
  for (std::size_t row = 0; row < recording.rate_dph.size(); ++row) {
    recording.rate_dph[row] += more(static_cast<double>(row));
  }
  const fog::test::MadeEvidence made(recording);
  return find_fast(made.evidence(), {}, made.series(), made.fit());
}

TEST(FastFinding, IsNothingInWhiteNoise) {
  const FastFinding finding = found_with([](double) { return 0.0; });
  EXPECT_EQ(finding.kind, FastKind::none);
  EXPECT_EQ(finding.excess, 0);
  EXPECT_GT(finding.log_p, rules::kFastLogP);
}

// A sine of half the noise's size has an eighth of its power: chi^2 of n / 8 for n rows, with a
// thousand periods in the run. It is compared with the median of 33 lines, known to a quarter.
TEST(FastFinding, IsALineWhereARateSwings) {
  constexpr double kRows = 3103;
  const FastFinding finding = found_with(
      [](double row) { return kRowNoise_dph / 2 * std::sin(2 * kPi * 1000 * row / kRows); });
  ASSERT_EQ(finding.kind, FastKind::line);
  EXPECT_EQ(finding.log_p, finding.spectrum.line_log_p);
  EXPECT_NEAR(finding.spectrum.line_period_s, 10 * kRows / 1000, 0.01);
  EXPECT_DOUBLE_EQ(finding.excess, finding.spectrum.line_share * kRows);
  EXPECT_NEAR(finding.excess, kRows / 8, 0.5 * kRows / 8);
}

// Noise with more power between periods of two and four rows, the same in every recording.
TEST(FastFinding, IsABandWhereAnOctaveIsLoud) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  double before = 0;
  const FastFinding finding = found_with([&](double) {
    const double now = kRowNoise_dph / 2 * normal(random);
    return now - std::exchange(before, now);
  });
  ASSERT_EQ(finding.kind, FastKind::band);
  EXPECT_EQ(finding.log_p, finding.spectrum.band_log_p);
  EXPECT_GT(finding.spectrum.band_period_s, 20);
  EXPECT_LT(finding.spectrum.band_period_s, 40);
}

// Ten minutes up, ten down, on average.
TEST(FastFinding, IsTwoLevelsWhereTheBiasJumpsToAndFro) {
  constexpr double kHeight_dph = 3 * kRowNoise_dph;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform;
  double side = 1;
  const FastFinding finding = found_with([&](double) {
    if (uniform(random) < 1.0 / 60) side = -side;
    return side * kHeight_dph / 2;
  });
  ASSERT_EQ(finding.kind, FastKind::two_levels);
  EXPECT_EQ(finding.log_p, -finding.jumps.log_odds);
  EXPECT_NEAR(finding.jumps.height_dph, kHeight_dph, 0.2 * kHeight_dph);
  EXPECT_EQ(finding.excess, finding.jumps.chi2_drop);
}

}  // namespace
}  // namespace fogcomp::diagnosis
