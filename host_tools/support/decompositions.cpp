#include "support/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace fogcomp {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd gram(const MatrixXd& a) {
  MatrixXd lower = MatrixXd::Zero(a.cols(), a.cols());
  lower.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
  return lower.selfadjointView<Eigen::Lower>();
}

namespace {

// Eigen stops at the first pivot that is not positive and returns a result all the same.
template <class Solution>
Solution if_definite(const Eigen::LLT<MatrixXd>& factors, const Solution& solution) {
  if (factors.info() == Eigen::Success) return solution;
  return Solution::Constant(solution.rows(), solution.cols(), std::nan(""));
}

}  // namespace

VectorXd solve_definite(const MatrixXd& a, const VectorXd& b) {
  const Eigen::LLT<MatrixXd> factors(a);
  return if_definite<VectorXd>(factors, factors.solve(b));
}

MatrixXd inverse_of_definite(const MatrixXd& a) {
  const Eigen::LLT<MatrixXd> factors(a);
  return if_definite<MatrixXd>(factors, factors.solve(MatrixXd::Identity(a.rows(), a.cols())));
}

MatrixXd cholesky_factor(const MatrixXd& a) {
  const Eigen::LLT<MatrixXd> factors(a);
  return if_definite<MatrixXd>(factors, factors.matrixL());
}

VectorXd solve_semidefinite(const MatrixXd& a, const VectorXd& b) {
  return a.ldlt().solve(b);
}

SymmetricEigen symmetric_eigen(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace fogcomp
