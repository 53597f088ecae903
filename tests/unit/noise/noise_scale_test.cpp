#include "noise/noise_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace fogcomp::noise {
namespace {

constexpr Eigen::Index kSizeOfRun = 6000;

series::Rows rows_of_10_s(std::vector<std::size_t> run_starts = {0}) {
  series::Rows rows;
  rows.row_s = 10;
  rows.drift_dph.setZero(kSizeOfRun);
  rows.weights.setOnes(kSizeOfRun);
  rows.run_starts = std::move(run_starts);
  for (Eigen::Index i = 0; i < kSizeOfRun; ++i) rows.time_s.push_back(10 * static_cast<double>(i));
  return rows;
}

Eigen::VectorXd normal_noise(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd values(kSizeOfRun);
  for (double& value : values) value = normal(random);
  return values;
}

Eigen::VectorXd scale_of(const Eigen::VectorXd& residual,
                         const std::vector<std::size_t>& run_starts = {0}) {
  return noise_scale(rows_of_10_s(run_starts), residual, Eigen::VectorXd::Ones(kSizeOfRun));
}

TEST(NoiseScale, IsOneWhereAllRowsHaveTheSameNoise) {
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    EXPECT_EQ(scale_of(normal_noise(seed)), Eigen::VectorXd::Ones(kSizeOfRun)) << seed;
  }
}

// A missing effect is not noise, however large.
TEST(NoiseScale, DoesNotFollowDrift) {
  Eigen::VectorXd residual = normal_noise(2);
  for (Eigen::Index row = 0; row < kSizeOfRun; ++row) {
    residual[row] += 20 * std::sin(static_cast<double>(row) / 100);  // 0.2 of the noise a row
    if (row >= 3000) residual[row] += 30;                            // a step
  }
  EXPECT_EQ(scale_of(residual, {0, 3000}), Eigen::VectorXd::Ones(kSizeOfRun));
}

TEST(NoiseScale, FollowsNoiseThatChanges) {
  Eigen::VectorXd residual = normal_noise(3);
  residual.segment(2000, 1000) *= 3;
  const Eigen::VectorXd scale = scale_of(residual);
  const double ratio = scale.segment(2100, 800).mean() / scale.head(1900).mean();
  EXPECT_GT(ratio, 2.3);
  EXPECT_LT(ratio, 3.2);
}

TEST(NoiseScale, OfRowsWithoutNoiseIsOne) {
  EXPECT_EQ(scale_of(Eigen::VectorXd::Constant(kSizeOfRun, 0.5)),
            Eigen::VectorXd::Ones(kSizeOfRun));
}

}  // namespace
}  // namespace fogcomp::noise
