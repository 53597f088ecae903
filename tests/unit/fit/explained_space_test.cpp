#include "fit/explained_space.hpp"

#include <gtest/gtest.h>

#include <random>

#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

Eigen::MatrixXd noise(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

Eigen::MatrixXf units(const Eigen::MatrixXd& columns) {
  return columns.colwise().normalized().cast<float>();
}

TEST(ExplainedSpace, GainsWhatLeastSquaresGains) {
  const Eigen::VectorXd residual = noise(200, 1, 1);
  const Eigen::MatrixXf a = units(noise(200, 2, 2));
  const Eigen::MatrixXf b = units(noise(200, 3, 3));
  ExplainedSpace space(residual);
  const auto in_a = space.add(a);
  const auto in_b = space.add(b);
  space.finish();
  const double left =
      solve_linear(side_by_side({a.cast<double>(), b.cast<double>()}, 200), residual)
          .residual.squaredNorm();
  EXPECT_NEAR(space.chi2_drop({in_a, in_b}), residual.squaredNorm() - left, 1e-6);
  EXPECT_NEAR(space.chi2_drop({in_b, in_a}), space.chi2_drop({in_a, in_b}), 1e-9);
}

TEST(ExplainedSpace, CountsAColumnThatIsThereTwiceOnce) {
  const Eigen::VectorXd residual = noise(100, 1, 4);
  const Eigen::MatrixXf a = units(noise(100, 1, 5));
  ExplainedSpace space(residual);
  const auto first = space.add(a);
  const auto second = space.add(a);
  space.finish();
  EXPECT_NEAR(space.chi2_drop({first, second}), space.chi2_drop({first}), 1e-5);
}

// More rows than are taken at once.
TEST(ExplainedSpace, SumsOverAllRows) {
  const Eigen::VectorXd residual = noise(2500, 1, 6);
  const Eigen::MatrixXf a = units(noise(2500, 2, 7));
  const Eigen::MatrixXd exact = a.cast<double>();
  ExplainedSpace space(residual);
  space.add(a);
  space.finish();
  EXPECT_LT((space.gram() - exact.transpose() * exact).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((space.projection() - exact.transpose() * residual).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(ExplainedSpace, ProjectsColumnsOut) {
  const Eigen::VectorXd residual = noise(200, 1, 8);
  const Eigen::MatrixXf a = units(noise(200, 2, 9));
  const Eigen::MatrixXf b =
      units(noise(200, 3, 10) + 0.1 * a.col(0).cast<double>().replicate(1, 3));
  const Eigen::MatrixXf none(200, 0);
  ExplainedSpace space(residual);
  const auto in_a = space.add(a);
  const auto in_b = space.add(b);
  const auto in_none = space.add(none);
  space.finish();
  const ExplainedSpace beside = space.without(in_b);
  EXPECT_NEAR(beside.chi2_drop({in_a}), space.chi2_drop({in_a, in_b}) - space.chi2_drop({in_b}),
              1e-5);
  EXPECT_NEAR(beside.chi2_drop({in_b}), 0, 1e-9);
  EXPECT_EQ(space.without(in_none).gram(), space.gram());
}

TEST(LogEvidence, AsksForMoreThanOneUnitAColumn) {
  EXPECT_EQ(log_evidence(1.9, 2), 0);
  EXPECT_GT(log_evidence(30, 1), log_evidence(30, 4));
  EXPECT_NEAR(log_evidence(30, 1), (30 - 1 - std::log(30.0)) / 2, 1e-12);
}

}  // namespace
}  // namespace fogcomp::fit
