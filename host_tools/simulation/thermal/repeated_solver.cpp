#include "simulation/thermal/repeated_solver.hpp"

#include <Eigen/SparseCholesky>
#include <type_traits>

namespace fogcomp::simulation {

RepeatedSolver::RepeatedSolver(const Eigen::SparseMatrix<double>& system) : work_(system.rows()) {
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(system);
  inverse_diagonal_ = factors.vectorD().cwiseInverse();
  const auto& places = factors.permutationP().indices();
  place_.assign(places.begin(), places.end());

  const Eigen::SparseMatrix<double> lower = factors.matrixL();
  const auto lay_out = [](const auto& by_line, Lines& lines) {
    for (Eigen::Index line = 0; line < by_line.outerSize(); ++line) {
      for (typename std::decay_t<decltype(by_line)>::InnerIterator at(by_line, line); at; ++at) {
        if (at.index() != line) lines.entries.push_back({at.index(), at.value()});
      }
      lines.begin.push_back(lines.entries.size());
    }
  };
  lay_out(lower, columns_);
  lay_out(Eigen::SparseMatrix<double, Eigen::RowMajor>(lower), rows_);
}

void RepeatedSolver::solve(Eigen::VectorXd& values) {
  const Eigen::Index size = values.size();
  const auto without = [this](const Lines& lines, Eigen::Index line) {
    const auto at = static_cast<std::size_t>(line);
    double value = work_[line];
    for (std::size_t i = lines.begin[at]; i < lines.begin[at + 1]; ++i) {
      value -= lines.entries[i].factor * work_[lines.entries[i].place];
    }
    return value;
  };
  for (Eigen::Index i = 0; i < size; ++i) work_[place_[static_cast<std::size_t>(i)]] = values[i];
  for (Eigen::Index line = 0; line < size; ++line) work_[line] = without(rows_, line);
  work_.array() *= inverse_diagonal_.array();
  for (Eigen::Index line = size - 1; line >= 0; --line) work_[line] = without(columns_, line);
  for (Eigen::Index i = 0; i < size; ++i) values[i] = work_[place_[static_cast<std::size_t>(i)]];
}

}  // namespace fogcomp::simulation
