#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp {

/// Of the largest: columns with smaller pivots are noise of the arithmetic.
constexpr double kMinPivot = 1e-9;

/// Linear least squares by column-pivoting QR, for rows of noise variance 1.
struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< of the coefficients; empty where rank < columns
  Eigen::VectorXd residual;
  Eigen::Index rank = 0;  ///< below the number of columns: some depend on each other
};

/// rows x columns matrix, a value per row; not a number throughout where one of these is none.
LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// The same for a matrix with noise of its own, which `instruments` (of the same size) share little
/// of: coefficients that the noise does not make smaller (two-stage least squares). Where the
/// instruments depend on each other, solve_linear().
LinearFit solve_with_instruments(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& instruments,
                                 const Eigen::VectorXd& values);

/// A column that adds nothing to those before it.
struct DependentColumn {
  Eigen::Index column = 0;
  std::vector<Eigen::Index> on;  ///< columns that make it up; none where it is 0 or not finite
};

/// Which columns make the rank of a matrix lacking, from left to right. Of a matrix of full rank
/// the column of which those before it leave the smallest share.
std::vector<DependentColumn> dependent_columns(const Eigen::MatrixXd& matrix);

/// An orthonormal basis of what the columns span, each of them first made one long; directions
/// below `rank_threshold` of the largest pivot, and columns of zeros, add nothing.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double rank_threshold = kMinPivot);

/// Columns less what an orthonormal basis (rows x any) can do of them.
Eigen::MatrixXd projected_out(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns);

/// sqrt(sum of weight * value^2 / sum of weights).
double weighted_rms(const Eigen::VectorXd& values, const Eigen::VectorXd& weights);

/// Matrices of `rows` rows as one; any number of columns each.
Eigen::MatrixXd side_by_side(const std::vector<Eigen::MatrixXd>& parts, Eigen::Index rows);

}  // namespace fogcomp
