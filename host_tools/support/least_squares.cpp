#include "support/least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "support/parallel.hpp"

namespace fogcomp {
namespace {

constexpr double kTie = 1e-4;  // relative preference of the first column to the last

// Indices of the unit columns that contribute to a dependent column.
std::vector<Eigen::Index> parts_of(const Eigen::MatrixXd& basis, const Eigen::VectorXd& column,
                                   const std::vector<Eigen::Index>& numbers) {
  constexpr double kPart = 1e-3;  // of a unit column
  std::vector<Eigen::Index> parts;
  if (basis.cols() == 0) return parts;
  const Eigen::VectorXd share = basis.colPivHouseholderQr().solve(column);
  for (Eigen::Index i = 0; i < share.size(); ++i) {
    if (std::abs(share[i]) > kPart) parts.push_back(numbers[static_cast<std::size_t>(i)]);
  }
  return parts;
}

// The decomposition's own solve() would use directions below its threshold as well.
Eigen::VectorXd solve_within_rank(const Eigen::ColPivHouseholderQR<Eigen::MatrixXd>& qr,
                                  Eigen::VectorXd values) {
  const Eigen::Index rank = qr.rank();
  values.applyOnTheLeft(qr.householderQ().setLength(rank).adjoint());
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(qr.cols());
  solution.head(rank) = qr.matrixQR()
                            .topLeftCorner(rank, rank)
                            .triangularView<Eigen::Upper>()
                            .solve(values.head(rank));
  return qr.colsPermutation() * solution;
}

}  // namespace

LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  // the pivot search needs finite numbers
  if (!matrix.allFinite() || !values.allFinite()) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {Eigen::VectorXd::Constant(matrix.cols(), kUnknown),
            {},
            Eigen::VectorXd::Constant(matrix.rows(), kUnknown),
            0};
  }
  // Scaled to unit columns, so that rank and conditioning do not depend on units.
  Eigen::VectorXd norms = matrix.colwise().norm().transpose();
  norms = norms.unaryExpr([](double norm) { return norm > 0 ? norm : 1.0; });
  const Eigen::VectorXd scale = norms.cwiseInverse();

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(kMinPivot);
  qr.compute(matrix * scale.asDiagonal());

  LinearFit fit;
  fit.rank = qr.rank();
  fit.coefficients = scale.cwiseProduct(solve_within_rank(qr, values));
  fit.residual = values - matrix * fit.coefficients;
  if (fit.rank == matrix.cols()) {
    const Eigen::MatrixXd r_inverse =
        qr.matrixQR().topRows(fit.rank).triangularView<Eigen::Upper>().solve(
            Eigen::MatrixXd::Identity(fit.rank, fit.rank));
    const Eigen::MatrixXd root = scale.asDiagonal() * (qr.colsPermutation() * r_inverse);
    fit.covariance = root * root.transpose();
  }
  return fit;
}

LinearFit solve_with_instruments(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& instruments,
                                 const Eigen::VectorXd& values) {
  const Eigen::MatrixXd basis = orthonormal(instruments, kMinPivot);
  if (basis.cols() < matrix.cols()) return solve_linear(matrix, values);
  LinearFit fit = solve_linear(basis.transpose() * matrix, basis.transpose() * values);
  fit.residual = values - matrix * fit.coefficients;
  return fit;
}

std::vector<DependentColumn> dependent_columns(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd orthonormal(matrix.rows(), matrix.cols());
  Eigen::MatrixXd independent(matrix.rows(), matrix.cols());
  std::vector<Eigen::Index> numbers;
  std::vector<DependentColumn> dependent;
  DependentColumn nearest;
  double nearest_left = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
    const double size = matrix.col(i).norm();
    if (!std::isfinite(size) || size == 0) {
      dependent.push_back({i, {}});
      continue;
    }
    const auto count = static_cast<Eigen::Index>(numbers.size());
    const auto before = orthonormal.leftCols(count);
    const Eigen::VectorXd unit = matrix.col(i) / size;
    // Twice: the second pass removes the rounding errors of the first.
    Eigen::VectorXd left = unit;
    for (int pass = 0; pass < 2; ++pass) left -= before * (before.transpose() * left).eval();
    const double norm = left.norm();
    if (norm <= kMinPivot) {
      dependent.push_back({i, parts_of(independent.leftCols(count), unit, numbers)});
      continue;
    }
    if (norm < nearest_left) {
      nearest_left = norm;
      nearest = {i, parts_of(independent.leftCols(count), unit, numbers)};
    }
    orthonormal.col(count) = left / norm;
    independent.col(count) = unit;
    numbers.push_back(i);
  }
  if (dependent.empty()) dependent.push_back(std::move(nearest));
  return dependent;
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double rank_threshold) {
  if (columns.cols() == 0) return columns;  // Eigen's decomposition needs a column
  Eigen::VectorXd scale = columns.colwise().norm().transpose();
  scale = scale.unaryExpr([](double norm) { return norm > 0 ? 1 / norm : 1.0; });
  // Of equal columns, such as sine and cosine, the first is taken first, whatever the rounding.
  scale.array() *= 1 - kTie * Eigen::ArrayXd::LinSpaced(scale.size(), 0, 1);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(rank_threshold);
  qr.compute(columns * scale.asDiagonal());
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

Eigen::MatrixXd projected_out(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& columns) {
  // Panels, the same for any number of threads and so of the same rounding.
  constexpr Eigen::Index kPanel = 16;
  Eigen::MatrixXd left(columns.rows(), columns.cols());
  const Eigen::Index panels = (columns.cols() + kPanel - 1) / kPanel;
  for_each_index(static_cast<std::size_t>(panels), [&](std::size_t panel) {
    const Eigen::Index first = static_cast<Eigen::Index>(panel) * kPanel;
    const Eigen::Index count = std::min(kPanel, columns.cols() - first);
    const auto own = columns.middleCols(first, count);
    const Eigen::MatrixXd within = basis.transpose() * own;
    left.middleCols(first, count) = own;
    left.middleCols(first, count).noalias() -= basis * within;
  });
  return left;
}

namespace {

template <typename Parts>
Eigen::MatrixXd joined(const Parts& parts, Eigen::Index rows) {
  Eigen::Index width = 0;
  for (const auto& part : parts) width += part.cols();
  Eigen::MatrixXd all(rows, width);
  Eigen::Index at = 0;
  for (const auto& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

}  // namespace

Eigen::MatrixXd side_by_side(const std::vector<Eigen::MatrixXd>& parts, Eigen::Index rows) {
  return joined(parts, rows);
}

Eigen::MatrixXd side_by_side(std::initializer_list<Eigen::Ref<const Eigen::MatrixXd>> parts,
                             Eigen::Index rows) {
  return joined(parts, rows);
}

double weighted_rms(const Eigen::VectorXd& values, const Eigen::VectorXd& weights) {
  return std::sqrt(values.cwiseAbs2().dot(weights) / weights.sum());
}

}  // namespace fogcomp
