#include "judge/prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "support/units.hpp"

namespace fogcomp::judge {
namespace {

constexpr Eigen::Index kRows = 600;

// A constant, a slow cycle and a fast one; white noise.
Rows rows_with(const Eigen::Vector3d& truth, double white_dph, std::uint64_t seed) {
  Random random(seed, "rows");
  Rows rows;
  rows.row_s = 10;
  rows.columns.resize(kRows, 3);
  rows.drift_dph.resize(kRows);
  for (Eigen::Index i = 0; i < kRows; ++i) {
    const double phase = 2 * kPi * static_cast<double>(i) / kRows;
    rows.columns.row(i) << 1, std::sin(2.3 * phase), std::sin(23 * phase);
    rows.drift_dph[i] = rows.columns.row(i).dot(truth) + white_dph * random.gaussian();
  }
  rows.prior_sigma = Eigen::VectorXd::Zero(3);
  rows.first_found = 3;
  rows.weights = Eigen::VectorXd::Ones(kRows);
  rows.stretches = {{0, kRows}};
  return rows;
}

const Eigen::Vector3d kTruth(0.7, -0.3, 0.1);

TEST(Prediction, Rows_WithoutNoise_GiveTheTruth) {
  const Prediction prediction(rows_with(kTruth, 1e-7, 1));
  EXPECT_LT((prediction.mean() - kTruth).norm(), 1e-6);
}

TEST(Prediction, WhiteNoise_Sigma_IsThatOfLeastSquares) {
  const Prediction prediction(rows_with(kTruth, 0.02, 1));
  EXPECT_NEAR(prediction.noise().white_dph, 0.02, 0.002);
  // A fast cycle has next to no slow noise beside it.
  EXPECT_NEAR(std::sqrt(prediction.covariance()(2, 2)), 0.02 * std::sqrt(2.0 / kRows), 1e-4);
}

TEST(Prediction, RandomWalk_WidensSlowColumnsOnly) {
  Rows rows = rows_with(kTruth, 0.02, 1);
  const Prediction quiet(rows);
  Random random(2, "walk");
  double walk = 0;
  for (double& value : rows.drift_dph) value += walk += 0.01 * random.gaussian();
  const Prediction walking(rows);
  const auto widened = [&](Eigen::Index i) {
    return std::sqrt(walking.covariance()(i, i) / quiet.covariance()(i, i));
  };
  EXPECT_GT(widened(1), 5);
  EXPECT_LT(widened(2), 2.5);
  EXPECT_NEAR(walking.noise().walk_dph_per_rth, 0.01 * std::sqrt(360), 0.06);
}

TEST(Prediction, ExcludedRows_DoNotCount) {
  Rows rows = rows_with(kTruth, 0.02, 1);
  const Prediction whole(rows);
  for (const Eigen::Index row : {0, 100, 101, 102, 599}) {
    rows.weights[row] = 0;
    rows.drift_dph[row] = 1e6;
  }
  const Prediction without(rows);
  EXPECT_LT((without.mean() - whole.mean()).norm(), 0.002);
}

TEST(Prediction, BiasesOfPowerOns_DoNotBendTheOthers) {
  Rows rows = rows_with(kTruth, 0.02, 1);
  rows.stretches = {{0, 200}, {200, 400}, {400, 600}};
  rows.power_ons = rows.stretches;
  rows.drift_dph.segment(200, 200).array() += 0.4;
  rows.drift_dph.segment(400, 200).array() -= 0.4;
  const Prediction prediction(rows);
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(prediction.mean()[i], kTruth[i], 4 * std::sqrt(prediction.covariance()(i, i)));
  }
  EXPECT_NEAR(prediction.turn_on_biases()[1] - prediction.turn_on_biases()[0], 0.4, 0.05);
  EXPECT_GT(prediction.noise().turn_on_dph, 0.2);
  EXPECT_GT(std::sqrt(prediction.covariance()(0, 0)), 0.1);
}

// A column that is another is known as well as beforehand: the covariance is finite.
TEST(Prediction, FoundShape_WithoutInformation_HasItsPrior) {
  Rows rows = rows_with(kTruth, 0.02, 1);
  rows.columns.conservativeResize(Eigen::NoChange, 4);
  rows.columns.col(3) = rows.columns.col(1);
  rows.prior_sigma.conservativeResize(4);
  rows.prior_sigma[3] = 0.3;
  const Prediction prediction(rows);
  EXPECT_NEAR(std::sqrt(prediction.covariance()(3, 3)), 0.3, 0.02);
  EXPECT_NEAR(std::sqrt(prediction.covariance()(1, 1)), 0.3, 0.02);
  EXPECT_NEAR(prediction.mean()[1], kTruth[1], 0.01);
}

}  // namespace
}  // namespace fogcomp::judge
