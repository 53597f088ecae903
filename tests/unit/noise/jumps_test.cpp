#include "noise/jumps.hpp"

#include <gtest/gtest.h>

#include <random>

#include "noise/noise_model.hpp"

namespace fogcomp::noise {
namespace {

// White noise of 1 and a first-order wander.
Eigen::VectorXd noise(Eigen::Index rows, double wander, double tau_rows, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double decay = std::exp(-1 / tau_rows);
  double state = wander * normal(random);
  return Eigen::VectorXd::NullaryExpr(rows, [&] {
    state = decay * state + wander * std::sqrt(1 - decay * decay) * normal(random);
    return state + normal(random);
  });
}

TEST(Jumps, PartAStretchWhereItsLevelChanges) {
  std::vector<Eigen::VectorXd> soaks;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) soaks.push_back(noise(400, 0.3, 20, seed));
  soaks[2].tail(150).array() += 3;
  const auto parts = split_at_jumps(soaks);
  ASSERT_EQ(parts.size(), 5U);
  EXPECT_NEAR(static_cast<double>(parts[2].size()), 250, 4);
  EXPECT_EQ(parts[2].size() + parts[3].size(), 400);

  const auto with = fit_noise(noise_samples(soaks), 10, 16000);
  soaks[2].tail(150).array() -= 3;
  const auto without = fit_noise(noise_samples(soaks), 10, 16000);
  EXPECT_NEAR(with.wander_dph(), without.wander_dph(), 0.3 * without.wander_dph());
}

TEST(Jumps, AreNoneInWanderAndSlopes) {
  int jumps = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    std::vector<Eigen::VectorXd> soaks;
    for (std::uint64_t soak = 0; soak < 5; ++soak) {
      soaks.push_back(
          noise(360, seed % 2 == 0 ? 1.5 : 0.5, seed % 3 == 0 ? 400 : 30, 1000 * seed + soak));
      soaks.back() += Eigen::VectorXd::LinSpaced(360, 0, 3);
    }
    jumps += static_cast<int>(split_at_jumps(soaks).size() - soaks.size());
  }
  EXPECT_LE(jumps, 1);
}

TEST(Jumps, AreNotMadeByRowsThatStandOut) {
  std::vector<Eigen::VectorXd> soaks;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    soaks.push_back(noise(400, 0.3, 20, seed));
    for (const Eigen::Index row : {120, 161, 300}) soaks.back()[row] += 25;
  }
  EXPECT_EQ(split_at_jumps(soaks).size(), 4U);
}

TEST(Jumps, AreNotLookedForInAShortStretchOrWithoutNoise) {
  EXPECT_EQ(split_at_jumps({Eigen::VectorXd::LinSpaced(40, 0, 1)}).size(), 1U);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(400);
  step.tail(100).setOnes();
  EXPECT_EQ(split_at_jumps({step}).size(), 1U);
  EXPECT_TRUE(split_at_jumps({}).empty());
}

}  // namespace
}  // namespace fogcomp::noise
