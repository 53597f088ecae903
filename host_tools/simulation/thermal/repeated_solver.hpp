#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace fogcomp::simulation {

/// Solves one sparse symmetric positive definite system for many right sides: factorised once by
/// Eigen, its factor's entries laid out in the order in which they are used, by rows for the way
/// down and by columns for the way up. The same to the bit as Eigen's own solution, in 3/5 of the
/// time (tests/bench/solver_speed.cpp).
class RepeatedSolver {
 public:
  explicit RepeatedSolver(const Eigen::SparseMatrix<double>& system);

  /// Right side in, solution out; as many values as the system has rows.
  void solve(Eigen::VectorXd& values);

 private:
  struct Entry {
    Eigen::Index place;  ///< of the other value
    double factor;
  };
  struct Lines {
    std::vector<Entry> entries;
    std::vector<std::size_t> begin{0};  ///< of each line's entries; behind the last, their number
  };

  Lines rows_;
  Lines columns_;
  Eigen::VectorXd inverse_diagonal_;
  std::vector<Eigen::Index> place_;  ///< of each value among those that are eliminated in turn
  Eigen::VectorXd work_;
};

}  // namespace fogcomp::simulation
