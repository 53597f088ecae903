#pragma once

#include <Eigen/Core>
#include <initializer_list>
#include <vector>

namespace fogcomp {

/// Smallest pivot relative to the largest: smaller ones are rounding errors.
constexpr double kMinPivot = 1e-9;

/// Linear least squares by column-pivoting QR, for rows of noise variance 1.
struct LinearFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;  ///< of the coefficients; empty if rank < columns
  Eigen::VectorXd residual;
  Eigen::Index rank = 0;  ///< less than the number of columns if they are linearly dependent
};

/// Solves rows x columns matrix = one value per row; all results are NaN if an input is not finite.
LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values);

/// The same for a matrix with noise, of which `instruments` (of the same size) share little: the
/// noise does not reduce the coefficients (two-stage least squares). If the instruments are
/// linearly dependent: solve_linear().
LinearFit solve_with_instruments(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& instruments,
                                 const Eigen::VectorXd& values);

/// A column that depends linearly on earlier ones.
struct DependentColumn {
  Eigen::Index column = 0;
  std::vector<Eigen::Index> on;  ///< columns that it depends on; empty if it is 0 or not finite
};

/// The dependent columns of a rank-deficient matrix, from left to right. For a matrix of full rank:
/// the column of which the earlier ones leave the smallest fraction.
std::vector<DependentColumn> dependent_columns(const Eigen::MatrixXd& matrix);

/// Orthonormal basis of the span of the columns, after scaling to unit length; directions below
/// `rank_threshold` of the largest pivot, and zero columns, are dropped.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double rank_threshold = kMinPivot);

/// Projects columns out of the span of an orthonormal basis (rows x any number).
Eigen::MatrixXd projected_out(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns);

/// sqrt(sum of weight * value^2 / sum of weights).
double weighted_rms(const Eigen::VectorXd& values, const Eigen::VectorXd& weights);

/// Concatenates matrices of `rows` rows, with any number of columns each.
Eigen::MatrixXd side_by_side(const std::vector<Eigen::MatrixXd>& parts, Eigen::Index rows);
Eigen::MatrixXd side_by_side(std::initializer_list<Eigen::Ref<const Eigen::MatrixXd>> parts,
                             Eigen::Index rows);

}  // namespace fogcomp
