#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "support/decompositions.hpp"
#include "support/fourier.hpp"
#include "support/least_squares.hpp"

namespace fogcomp {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd definite() {
  MatrixXd a(3, 3);
  a << 4, 1, 0, 1, 3, -1, 0, -1, 2;
  return a;
}

TEST(Decompositions, SolveWhatTheySay) {
  const MatrixXd a = definite();
  const VectorXd b = VectorXd::LinSpaced(3, 1, 5);
  EXPECT_LT((a * solve_definite(a, b) - b).norm(), 1e-14);
  EXPECT_LT((a * solve_semidefinite(a, b) - b).norm(), 1e-14);
  EXPECT_LT((a * inverse_of_definite(a) - MatrixXd::Identity(3, 3)).norm(), 1e-14);
  const MatrixXd lower = cholesky_factor(a);
  EXPECT_LT((lower * lower.transpose() - a).norm(), 1e-14);
  EXPECT_EQ(lower(0, 2), 0);
  const SymmetricEigen eigen = symmetric_eigen(a);
  EXPECT_LT((a * eigen.vectors - eigen.vectors * eigen.values.asDiagonal()).norm(), 1e-13);
  EXPECT_LT(eigen.values[0], eigen.values[2]);
  const MatrixXd tall = MatrixXd::Random(40, 3);
  EXPECT_LT((gram(tall) - tall.transpose() * tall).norm(), 1e-13);
}

TEST(Decompositions, SayWhereAMatrixIsNotDefinite) {
  MatrixXd a = definite();
  a(2, 2) = -2;
  EXPECT_TRUE(solve_definite(a, VectorXd::Ones(3)).array().isNaN().all());
  EXPECT_TRUE(inverse_of_definite(a).array().isNaN().all());
  EXPECT_TRUE(cholesky_factor(a).array().isNaN().all());
}

TEST(Decompositions, SolveASingularSystemThatHasASolution) {
  MatrixXd a(2, 2);
  a << 1, 1, 1, 1;
  EXPECT_LT((a * solve_semidefinite(a, VectorXd::Constant(2, 3)) - VectorXd::Constant(2, 3)).norm(),
            1e-14);
}

TEST(LeastSquares, TakesNoColumnsAndSaysWhereANumberIsNone) {
  EXPECT_EQ(orthonormal(MatrixXd(50, 0)).cols(), 0);
  MatrixXd columns = MatrixXd::Random(50, 2);
  columns(7, 1) = HUGE_VAL;
  const LinearFit fit = solve_linear(columns, VectorXd::Ones(50));
  EXPECT_EQ(fit.rank, 0);
  EXPECT_EQ(fit.covariance.size(), 0);
  EXPECT_TRUE(fit.coefficients.array().isNaN().all());
}

TEST(LeastSquares, SaysWhichColumnsDependOnWhich) {
  MatrixXd columns = MatrixXd::Random(50, 6);
  columns.col(2) = 1e6 * (columns.col(0) - columns.col(1));
  columns.col(4).setZero();
  columns(7, 5) = std::nan("");
  const std::vector<DependentColumn> dependent = dependent_columns(columns);
  ASSERT_EQ(dependent.size(), 3U);
  EXPECT_EQ(dependent[0].column, 2);
  EXPECT_EQ(dependent[0].on, (std::vector<Eigen::Index>{0, 1}));
  EXPECT_EQ(dependent[1].column, 4);
  EXPECT_TRUE(dependent[1].on.empty());
  EXPECT_EQ(dependent[2].column, 5);
  const std::vector<DependentColumn> nearest = dependent_columns(MatrixXd::Random(50, 3));
  EXPECT_EQ(nearest.size(), 1U);
}

// A direction of rounding errors takes no part: its coefficient would be huge, and so the rounding
// of the sum.
TEST(LeastSquares, LeavesOutADirectionBelowTheThreshold) {
  MatrixXd columns = MatrixXd::Random(500, 3);
  const VectorXd values = VectorXd::Random(500);
  const double left = solve_linear(columns.leftCols(2), values).residual.norm();
  columns.col(2) = columns.col(0) + columns.col(1) + 1e-12 * columns.col(2);
  const LinearFit fit = solve_linear(columns, values);
  EXPECT_EQ(fit.rank, 2);
  EXPECT_LT(fit.coefficients.norm(), 1);
  EXPECT_NEAR(fit.residual.norm(), left, 1e-9);
}

TEST(LeastSquares, TakesEqualColumnsInTheirOrderWhateverTheRounding) {
  MatrixXd columns = MatrixXd::Random(50, 2);
  columns.col(1) *= columns.col(0).norm() / columns.col(1).norm();
  for (const double rounding : {1 - 1e-14, 1.0, 1 + 1e-14}) {
    MatrixXd rounded = columns;
    rounded(7, 1) *= rounding;
    const VectorXd first = orthonormal(rounded).col(0);
    EXPECT_NEAR(std::abs(first.dot(columns.col(0))) / columns.col(0).norm(), 1, 1e-9);
  }
}

TEST(LeastSquares, LeavesOutAColumnThatIsASumOfOthers) {
  MatrixXd columns = MatrixXd::Random(50, 3);
  columns.col(2) = 1e6 * (columns.col(0) + columns.col(1));
  EXPECT_EQ(orthonormal(columns).cols(), 2);
  const LinearFit fit = solve_linear(columns, columns.col(0) - columns.col(1));
  EXPECT_EQ(fit.rank, 2);
  EXPECT_EQ(fit.covariance.size(), 0);
  EXPECT_LT(fit.residual.norm(), 1e-12);
}

TEST(Periodogram, OfACosineIsOneLineAndOfAllTheMeanSquare) {
  // The last is a prime: hours of a gyro at rest.
  for (const std::size_t size : {96U, 97U, 131U, 59051U}) {
    std::vector<double> values(size);
    const double step = 2 * std::acos(-1.0) * 5 / static_cast<double>(size);
    for (std::size_t i = 0; i < size; ++i) values[i] = 2 * std::cos(step * static_cast<double>(i));
    const std::vector<double> powers = periodogram(values);
    EXPECT_EQ(powers.size(), (size + 1) / 2);
    for (std::size_t k = 0; k < powers.size(); ++k) {
      EXPECT_NEAR(powers[k], k == 5 ? static_cast<double>(size) : 0, 1e-9) << size << " " << k;
    }
  }
}

TEST(Periodogram, IsThatOfTheDefinition) {
  for (const int size : {2, 3, 46, 53, 59, 106, 127}) {
    const VectorXd values = VectorXd::Random(size);
    const std::vector<double> powers = periodogram({values.begin(), values.end()});
    for (std::size_t k = 0; k < powers.size(); ++k) {
      std::complex<double> sum = 0;
      for (int i = 0; i < size; ++i) {
        sum += values[i] * std::polar(1.0, 2 * std::acos(-1.0) * i * static_cast<double>(k) / size);
      }
      EXPECT_NEAR(powers[k], std::norm(sum) / size, 1e-12) << size << " " << k;
    }
  }
}

TEST(Periodogram, OfOneValueIsItsSquareAndOfNoneIsNone) {
  EXPECT_EQ(periodogram({3}), (std::vector<double>{9}));
  EXPECT_TRUE(periodogram({}).empty());
}

}  // namespace
}  // namespace fogcomp
