#include "judge/score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fogcomp::judge {
namespace {

Foretold foretold(const Eigen::VectorXd& mean, double variance) {
  return {mean, Eigen::VectorXd::Constant(mean.size(), variance)};
}

Eigen::VectorXd noise_of(Eigen::Index rows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::VectorXd::NullaryExpr(rows, [&] { return normal(random); });
}

TEST(Score, GainIsTheLogarithmOfTheRatioOfDensities) {
  const Eigen::VectorXd measured = Eigen::VectorXd::Constant(1, 2);
  const Score one = score(measured, foretold(Eigen::VectorXd::Zero(1), 1),
                          foretold(Eigen::VectorXd::Constant(1, 1), 4));
  EXPECT_NEAR(one.gain, (4 - 0.25 - std::log(4)) / 2, 1e-12);
}

// Cox: for two means in white noise of variance 1 the gain scatters by their distance.
TEST(Score, StandardError_IsTheScatterOfTheGain) {
  const Eigen::VectorXd mean = Eigen::VectorXd::Constant(100, 0.3);
  double sum = 0;
  double squares = 0;
  constexpr int kDraws = 2000;
  double claimed = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    const Score one = score(mean + noise_of(100, static_cast<std::uint64_t>(draw)),
                            foretold(Eigen::VectorXd::Zero(100), 1), foretold(mean, 1));
    sum += one.gain;
    squares += one.gain * one.gain;
    claimed = one.standard_error;
  }
  EXPECT_NEAR(sum / kDraws, mean.squaredNorm() / 2, 0.3);
  EXPECT_NEAR(claimed, mean.norm(), 1e-12);
  EXPECT_NEAR(std::sqrt(squares / kDraws - std::pow(sum / kDraws, 2)), claimed, 0.1 * claimed);
}

TEST(Score, TheSameForetold_SaysNothing) {
  const Foretold both = foretold(Eigen::VectorXd::Zero(10), 1);
  const Score one = score(noise_of(10, 1), both, both);
  EXPECT_EQ(one.gain, 0);
  EXPECT_FALSE(one.improves());
  EXPECT_FALSE(one.harms());
}

TEST(Score, RowThatIsNotForetold_DoesNotCount) {
  Foretold before = foretold(Eigen::VectorXd::Zero(2), 1);
  Foretold after = foretold(Eigen::VectorXd::Constant(2, 3), 1);
  const Eigen::VectorXd measured = Eigen::VectorXd::Constant(2, 3);
  EXPECT_NEAR(score(measured, before, after).gain, 9, 1e-12);
  after.variance[1] = 0;
  EXPECT_NEAR(score(measured, before, after).gain, 4.5, 1e-12);
}

// One that knows nothing of a row cannot make the verdict uncertain.
TEST(Score, UnsureRow_CostsItsOwnDensityOnly) {
  Foretold before = foretold(Eigen::VectorXd::Zero(101), 1);
  Foretold after = foretold(Eigen::VectorXd::Constant(101, 1), 1);
  after.variance[0] = 1e6;
  const Eigen::VectorXd measured = Eigen::VectorXd::Constant(101, 1);
  const Score one = score(measured, before, after);
  EXPECT_NEAR(one.gain, 50 + 0.5 - std::log(1e6) / 2, 1e-4);
  EXPECT_NEAR(one.standard_error, std::sqrt(100.5), 1e-3);
  EXPECT_TRUE(one.improves());
}

}  // namespace
}  // namespace fogcomp::judge
