#pragma once

#include <Eigen/Core>

// Eigen's decompositions, each compiled once: a file that names one takes seconds longer to
// compile.
namespace fogcomp {

/// A' A.
Eigen::MatrixXd gram(const Eigen::MatrixXd& a);

/// The x of A x = b for a symmetric positive definite A: a factorisation A = L L'. All three are no
/// numbers where A is not definite.
Eigen::VectorXd solve_definite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd inverse_of_definite(const Eigen::MatrixXd& a);
/// The lower L of A = L L', zeros above.
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& a);

/// The x of A x = b for a symmetric A that may be singular up to rounding: A = P' L D L' P.
Eigen::VectorXd solve_semidefinite(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A = V diag(values) V' of a symmetric A, values ascending.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;  ///< a column each
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);

}  // namespace fogcomp
