#include "diagnosis/null_test.hpp"

#include <gtest/gtest.h>

#include <deque>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/chance.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

using fit::ExplainedSpace;
using series::ColumnRange;

constexpr Eigen::Index kSpaceRows = 120;
constexpr double kFreedom = 200;

Eigen::MatrixXd noise_columns(Eigen::Index columns, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(kSpaceRows, columns, [&] { return normal(random); });
}

// Effects of one and two columns, several similar shapes each, and six smooth functions.
NullTest tested(const Eigen::VectorXd& residual, std::size_t effects = 5, std::uint64_t seed = 1) {
  ExplainedSpace space(residual);
  std::deque<Eigen::MatrixXf> columns;
  const auto add = [&](const Eigen::MatrixXd& some) {
    return space.add(columns.emplace_back(orthonormal(some).cast<float>()));
  };
  RegressorBasis regressors;
  for (std::size_t effect = 0; effect < effects; ++effect) {
    regressors.emplace_back();
    const Eigen::MatrixXd base =
        noise_columns(1 + static_cast<Eigen::Index>(effect) % 2, 100 + effect);
    for (std::uint64_t shape = 0; shape < 4; ++shape) {
      const Eigen::MatrixXd other = noise_columns(base.cols(), 1000 + 10 * effect + shape);
      regressors.back().push_back(add(base + other));
    }
  }
  const ColumnRange structure = add(noise_columns(6, 99));
  space.finish();
  return test_against_noise(space, regressors, structure, kFreedom, seed);
}

TEST(NullTest, IsPassedByNoiseAsOftenAsItSays) {
  std::vector<double> regressors;
  std::vector<double> structure;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    const NullTest test = tested(noise_columns(1, 5000 + seed), 5, seed);
    regressors.push_back(std::exp(test.library_log_p));
    structure.push_back(std::exp(test.structure_log_p));
  }
  fog::test::expect_chances_are_true(regressors);
  fog::test::expect_chances_are_true(structure);
  // And not by much more: half of the probabilities are below a half, at most three quarters above.
  for (const auto& chances : {regressors, structure}) {
    const auto large =
        std::count_if(chances.begin(), chances.end(), [](double p) { return p > 0.5; });
    EXPECT_LT(large, 90);  // of a right test once in 10^7 times
  }
}

TEST(NullTest, IsFailedByAnEffect) {
  const Eigen::VectorXd effect = (noise_columns(1, 100) + noise_columns(1, 1000)).normalized();
  double before = 1;
  for (const double sigmas : {0.0, 4.0, 7.0, 15.0}) {
    const double chance = std::exp(tested(noise_columns(1, 7) + sigmas * effect).library_log_p);
    EXPECT_LT(chance, before) << sigmas;
    before = chance;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(NullTest, OfSmoothStructureIsFailedByWhatNoEffectExplains) {
  const Eigen::VectorXd smooth = orthonormal(noise_columns(6, 99)).col(2);
  const NullTest test = tested(noise_columns(1, 7) + 10 * smooth);
  EXPECT_LT(test.structure_log_p, std::log(1e-4));
}

TEST(NullTest, CountsEveryEffectThatIsTried) {
  const Eigen::VectorXd effect = (noise_columns(1, 100) + noise_columns(1, 1000)).normalized();
  const Eigen::VectorXd residual = noise_columns(1, 7) + 4 * effect;
  EXPECT_GT(tested(residual, 25).library_log_p, tested(residual, 1).library_log_p);
}

TEST(NullTest, GivesTheSameForTheSameSeedAndNearlyTheSameForAnother) {
  const Eigen::VectorXd residual = noise_columns(1, 8);
  const NullTest once = tested(residual, 5, 3);
  EXPECT_EQ(once.library_log_p, tested(residual, 5, 3).library_log_p);
  EXPECT_EQ(once.structure_log_p, tested(residual, 5, 3).structure_log_p);
  EXPECT_NEAR(std::exp(once.library_log_p), std::exp(tested(residual, 5, 4).library_log_p), 0.15);
}

TEST(NullTest, OfARowOfZerosIsNotSurprised) {
  const NullTest test = tested(Eigen::VectorXd::Zero(kSpaceRows));
  EXPECT_GT(test.library_log_p, std::log(0.5));
  EXPECT_GT(test.structure_log_p, std::log(0.5));
}

}  // namespace
}  // namespace fogcomp::diagnosis
