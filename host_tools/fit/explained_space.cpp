#include "fit/explained_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/decompositions.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

// Of unit columns: two that agree to 1e-8 count as one.
constexpr double kSystemRidge = 1e-8;
constexpr Eigen::Index kRowsAtOnce = 1024;

}  // namespace

series::ColumnRange ExplainedSpace::add(const Eigen::MatrixXf& columns) {
  const series::ColumnRange range{width_, columns.cols()};
  width_ += columns.cols();
  parts_.push_back(&columns);
  return range;
}

// A few rows of all parts at a time.
void ExplainedSpace::finish() {
  gram_.setZero(width_, width_);
  projection_.setZero(width_);
  Eigen::MatrixXd rows;
  for (Eigen::Index first = 0; first < residual_.size(); first += kRowsAtOnce) {
    const Eigen::Index count = std::min(kRowsAtOnce, residual_.size() - first);
    rows.resize(count, width_);
    Eigen::Index at = 0;
    for (const Eigen::MatrixXf* const part : parts_) {
      rows.middleCols(at, part->cols()) = part->middleRows(first, count).cast<double>();
      at += part->cols();
    }
    add_to_gram(rows, gram_);
    projection_ += rows.transpose() * residual_.segment(first, count);
  }
  gram_.triangularView<Eigen::StrictlyUpper>() = gram_.transpose();
  parts_.clear();
}

Eigen::MatrixXd ExplainedSpace::root_of_noise(const series::ColumnRange& random,
                                              const Eigen::VectorXd& variances) const {
  Eigen::MatrixXd inner = gram_.block(random.first, random.first, random.count, random.count);
  inner.diagonal() += variances.cwiseInverse();
  return cholesky_factor(inner);
}

// Woodbury: with noise of covariance I + R V R', a'b becomes a'b - a'R (R'R + 1/V)^-1 R'b.
ExplainedSpace ExplainedSpace::with_noise(const series::ColumnRange& random,
                                          const Eigen::VectorXd& variances) const {
  const Eigen::MatrixXd root = root_of_noise(random, variances);
  const auto half = root.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd columns = half.solve(gram_.middleRows(random.first, random.count));
  const Eigen::VectorXd residual = half.solve(projection_.segment(random.first, random.count));
  ExplainedSpace with = *this;
  with.gram_ -= fogcomp::gram(columns);
  with.projection_ -= columns.transpose() * residual;
  return with;
}

ExplainedSpace ExplainedSpace::without(const series::ColumnRange& part) const {
  if (part.count == 0) return *this;
  constexpr double kAny = std::numeric_limits<double>::infinity();
  return with_noise(part, Eigen::VectorXd::Constant(part.count, kAny));
}

double ExplainedSpace::log_likelihood_of_noise(const series::ColumnRange& random,
                                               const Eigen::VectorXd& variances) const {
  const Eigen::MatrixXd root = root_of_noise(random, variances);
  const Eigen::VectorXd residual =
      root.triangularView<Eigen::Lower>().solve(projection_.segment(random.first, random.count));
  const double log_determinant = (root.diagonal().array().square() * variances.array()).log().sum();
  return (residual.squaredNorm() - log_determinant) / 2;
}

double ExplainedSpace::chi2_drop(const std::vector<series::ColumnRange>& parts) const {
  std::vector<Eigen::Index> columns;
  for (const series::ColumnRange& part : parts) {
    for (Eigen::Index i = part.first; i < part.first + part.count; ++i) columns.push_back(i);
  }
  Eigen::MatrixXd matrix = gram_(columns, columns);
  matrix.diagonal().array() += kSystemRidge;
  const Eigen::VectorXd right = projection_(columns);
  return right.dot(solve_definite(matrix, right));
}

double log_evidence(double chi2_drop, double columns) {
  if (chi2_drop <= columns) return 0;
  return (chi2_drop - columns) / 2 - columns / 2 * std::log(chi2_drop / columns);
}

}  // namespace fogcomp::fit
