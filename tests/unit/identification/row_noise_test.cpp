#include "identification/row_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

constexpr Eigen::Index kRows = 6000;

fogcomp::Rows rows_of_10_s(std::vector<std::size_t> run_starts = {0}) {
  fogcomp::Rows rows;
  rows.row_s = 10;
  rows.drift_dph.setZero(kRows);
  rows.weights.setOnes(kRows);
  rows.run_starts = std::move(run_starts);
  for (Eigen::Index i = 0; i < kRows; ++i) rows.time_s.push_back(10 * static_cast<double>(i));
  return rows;
}

Eigen::VectorXd normal_noise(std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Eigen::VectorXd values(kRows);
  for (double& value : values) value = normal(random);
  return values;
}

std::size_t left_out(const fogcomp::RowNoise& noise) {
  return static_cast<std::size_t>((noise.counted.array() <= 0).count());
}

// Four in 100,000: 1.2 of five recordings' 30,000 rows; 7 or more would be seen once in 2,000
// times.
TEST(RowNoise, LeavesNormalNoiseAlone) {
  std::size_t out = 0;
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const fogcomp::RowNoise noise = fogcomp::row_noise(rows_of_10_s(), normal_noise(seed));
    out += left_out(noise);
    EXPECT_EQ(noise.scale.minCoeff(), 1) << seed;
    EXPECT_EQ(noise.scale.maxCoeff(), 1) << seed;
  }
  EXPECT_LT(out, 7U);
}

TEST(RowNoise, LeavesOutRowsThatStandOutOfTheirNeighboursAlone) {
  Eigen::VectorXd residual = normal_noise(1);
  for (const Eigen::Index row : {700, 2000, 2001, 4500}) residual[row] = 10;
  const fogcomp::RowNoise noise = fogcomp::row_noise(rows_of_10_s(), residual);
  for (const Eigen::Index row : {700, 2000, 2001, 4500}) EXPECT_EQ(noise.counted[row], 0) << row;
  EXPECT_LE(left_out(noise), 6U);
}

// What an effect does that the model lacks: far out, but together with its neighbours.
TEST(RowNoise, TakesNoExcursionForOutliers) {
  Eigen::VectorXd residual = normal_noise(2);
  for (Eigen::Index row = 0; row < kRows; ++row) {
    residual[row] += 20 * std::sin(static_cast<double>(row) / 100);  // 0.2 of the noise a row
    if (row >= 3000) residual[row] += 30;                            // a step
    if (row >= 5000 && row < 5012) residual[row] += 15;              // two minutes
  }
  const fogcomp::RowNoise noise = fogcomp::row_noise(rows_of_10_s({0, 3000}), residual);
  EXPECT_LE(left_out(noise), 3U);
}

TEST(RowNoise, FollowsNoiseThatChanges) {
  Eigen::VectorXd residual = normal_noise(3);
  residual.segment(2000, 1000) *= 3;
  const fogcomp::RowNoise noise = fogcomp::row_noise(rows_of_10_s(), residual);
  const double quiet = noise.scale.head(1900).mean();
  const double noisy = noise.scale.segment(2100, 800).mean();
  EXPECT_GT(noisy / quiet, 2.3);
  EXPECT_LT(noisy / quiet, 3.2);
  EXPECT_LE(left_out(noise), 14U);  // of equal noise 140 would
}

TEST(RowNoise, OfRowsWithoutAnyIsOne) {
  const fogcomp::RowNoise noise =
      fogcomp::row_noise(rows_of_10_s(), Eigen::VectorXd::Constant(kRows, 0.5));
  EXPECT_EQ(left_out(noise), 0U);
  EXPECT_EQ(noise.scale, Eigen::VectorXd::Ones(kRows));
}

TEST(RowNoise, BridgesWhatDoesNotCount) {
  Eigen::VectorXd counted = Eigen::VectorXd::Ones(4);
  counted[2] = 0;
  EXPECT_EQ(fogcomp::bridged(Eigen::Vector4d(1, 2, 50, 3), counted), Eigen::Vector4d(1, 2, 2, 3));
}

}  // namespace
