#include "diagnosis/two_levels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fogcomp::diagnosis {
namespace {

constexpr double kWhite_dph = 0.03;
constexpr double kRow_s = 10;
constexpr double kDwell_rows = 100;

enum class Process { two_levels, wander };

// Three soaks of white noise and a process with the same autocovariance, of either kind.
std::vector<Eigen::VectorXd> soaks(Process process, double height_dph, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const double decay = std::exp(-2 / kDwell_rows);
  std::vector<Eigen::VectorXd> stretches;
  for (const Eigen::Index rows : {700, 900, 800}) {
    Eigen::VectorXd values(rows);
    double state = process == Process::wander ? normal(random) : 1;
    for (double& value : values) {
      if (process == Process::wander) {
        state = decay * state + std::sqrt(1 - decay * decay) * normal(random);
      } else if (uniform(random) < (1 - decay) / 2) {
        state = -state;
      }
      value = height_dph / 2 * state + kWhite_dph * normal(random);
    }
    stretches.push_back(values);
  }
  return stretches;
}

TEST(TwoLevels, AreToldFromWanderOfTheSameSpectrum) {
  constexpr double kHeight_dph = 0.05;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const TwoLevels jumps =
        find_two_levels(soaks(Process::two_levels, kHeight_dph, seed), kWhite_dph, kRow_s);
    EXPECT_GT(jumps.log_odds, 8) << seed;
    EXPECT_NEAR(jumps.height_dph, kHeight_dph, 0.2 * kHeight_dph) << seed;
    EXPECT_GT(jumps.dwell_s, kDwell_rows * kRow_s / 3) << seed;
    EXPECT_LT(jumps.dwell_s, kDwell_rows * kRow_s * 3) << seed;
    const TwoLevels wander =
        find_two_levels(soaks(Process::wander, kHeight_dph, seed), kWhite_dph, kRow_s);
    EXPECT_LT(wander.log_odds, 0) << seed;
  }
}

TEST(TwoLevels, AreNotSeenInWhiteNoise) {
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    EXPECT_LT(find_two_levels(soaks(Process::wander, 0, seed), kWhite_dph, kRow_s).log_odds, 3)
        << seed;
  }
  EXPECT_EQ(find_two_levels({}, kWhite_dph, kRow_s).log_odds, 0);
}

// An excluded row is not a level, and does not hide levels.
TEST(TwoLevels, ArePassedOverByRowsThatDoNotCount) {
  std::vector<Eigen::VectorXd> stretches = soaks(Process::two_levels, 0.05, 1);
  for (Eigen::VectorXd& stretch : stretches) {
    for (Eigen::Index row = 3; row < stretch.size(); row += 50) stretch[row] = std::nan("");
  }
  EXPECT_GT(find_two_levels(stretches, kWhite_dph, kRow_s).log_odds, 8);
  EXPECT_EQ(
      find_two_levels({Eigen::VectorXd::Constant(700, std::nan(""))}, kWhite_dph, kRow_s).log_odds,
      0);
}

// A step, or the end of a soak with a late temperature record, is no switching between two levels.
TEST(TwoLevels, ComeAndGo) {
  std::vector<Eigen::VectorXd> stretches = soaks(Process::wander, 0, 1);
  for (Eigen::VectorXd& stretch : stretches) stretch.tail(40).array() += 5 * kWhite_dph;
  EXPECT_EQ(find_two_levels(stretches, kWhite_dph, kRow_s).log_odds, 0);
  for (Eigen::VectorXd& stretch : stretches) stretch.segment(200, 40).array() += 5 * kWhite_dph;
  EXPECT_GT(find_two_levels(stretches, kWhite_dph, kRow_s).log_odds, 8);
}

}  // namespace
}  // namespace fogcomp::diagnosis
