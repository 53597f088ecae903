#pragma once

#include <Eigen/Core>

// Eigen's decompositions, compiled once, because each takes seconds to compile.
namespace fogcomp {

/// A' A.
Eigen::MatrixXd gram(const Eigen::MatrixXd& a);
/// Adds A' A to the lower triangle, the diagonal included, of a square matrix of A's columns.
void add_to_gram(const Eigen::MatrixXd& a, Eigen::MatrixXd& lower);

/// Solves A x = b for a symmetric positive definite A by A = L L'. All results are NaN if A is not
/// definite.
Eigen::VectorXd solve_definite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd inverse_of_definite(const Eigen::MatrixXd& a);
/// Lower triangular L of A = L L'.
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& a);

/// Solves A x = b for a symmetric A that may be singular up to rounding: A = P' L D L' P.
Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A = V diag(values) V' of a symmetric A, values ascending.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< one per column
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);

}  // namespace fogcomp
