#include "support/decompositions.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>

#include "support/parallel.hpp"

namespace fogcomp {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void add_to_gram(const MatrixXd& a, MatrixXd& lower) {
  // Panels of the lower triangle, the same for any number of threads and so of the same rounding.
  constexpr Eigen::Index kPanel = 48;
  const Eigen::Index panels = (a.cols() + kPanel - 1) / kPanel;
  for_each_index(static_cast<std::size_t>(panels), [&](std::size_t panel) {
    const Eigen::Index first = static_cast<Eigen::Index>(panel) * kPanel;
    const Eigen::Index count = std::min(kPanel, a.cols() - first);
    const Eigen::Index below = a.cols() - first;
    lower.block(first, first, below, count).noalias() +=
        a.rightCols(below).transpose() * a.middleCols(first, count);
  });
}

MatrixXd gram(const MatrixXd& a) {
  MatrixXd lower = MatrixXd::Zero(a.cols(), a.cols());
  add_to_gram(a, lower);
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
  if (a.size() == 0) return {};  // of which Eigen reads a first value
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace fogcomp
