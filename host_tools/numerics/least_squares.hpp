#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp {

/// Of the largest: columns with smaller pivots are noise of the arithmetic.
constexpr double kLeastPivot = 1e-9;

/// Linear least squares by column-pivoting QR, for rows of noise variance 1.
struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< of the coefficients; empty where rank < columns
  Eigen::VectorXd residual;
  Eigen::Index rank = 0;  ///< below the number of columns: some depend on each other
};

/// rows x columns matrix, a value per row.
LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// The same for a matrix with noise of its own, which `instruments` (of the same size) share little
/// of: coefficients that the noise does not make smaller (two-stage least squares). Where the
/// instruments depend on each other, solve_linear().
LinearFit solve_with_instruments(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& instruments,
                                 const Eigen::VectorXd& values);

/// An orthonormal basis of what the columns span, each of them first made one long; directions
/// below `rank_threshold` of the largest pivot, and columns of zeros, add nothing.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double rank_threshold = kLeastPivot);

/// Matrices of `rows` rows as one; any number of columns each.
Eigen::MatrixXd side_by_side(const std::vector<Eigen::MatrixXd>& parts, Eigen::Index rows);

}  // namespace fogcomp
