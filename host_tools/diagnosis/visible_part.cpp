#include "diagnosis/visible_part.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace fogcomp {
namespace {

constexpr double kRankThreshold = 1e-8;
// The sensor's own lag against that of the winding, one standard deviation.
constexpr double kSensorDelay_s = 30;

bool starts_run(const Rows& rows, std::size_t row) {
  return std::binary_search(rows.run_starts.begin(), rows.run_starts.end(), row);
}

// d/dt of a series of rows, per second; 0 where a run begins or ends.
Eigen::VectorXd slope(const Rows& rows, const Eigen::VectorXd& values) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (starts_run(rows, row) || starts_run(rows, row + 1)) continue;
    result[i] = (values[i + 1] - values[i - 1]) / (rows.time_s[row + 1] - rows.time_s[row - 1]);
  }
  return result;
}

Eigen::MatrixXd with_row(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd longer = Eigen::MatrixXd::Zero(columns.rows() + 1, columns.cols());
  longer.topRows(columns.rows()) = columns;
  return longer;
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns) {
  Eigen::VectorXd scale = columns.colwise().norm().transpose();
  scale = scale.unaryExpr([](double norm) { return norm > 0 ? 1 / norm : 1.0; });
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(kRankThreshold);
  qr.compute(columns * scale.asDiagonal());
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

}  // namespace

ModelRemover::ModelRemover(const Rows& rows, const NoiseWeightedFit& fit)
    : whitening_(fit.noise, rows, fit.row_weights) {
  const Eigen::VectorXd drift = fit.columns * fit.coefficients;
  Eigen::MatrixXd columns(rows.size() + 1, fit.whitened.cols() + 1);
  columns.leftCols(fit.whitened.cols()) = with_row(fit.whitened);
  columns.rightCols(1) = with_row(whitening_.apply(slope(rows, drift)));
  columns(rows.size(), fit.whitened.cols()) = 1 / kSensorDelay_s;
  basis_ = orthonormal(columns);
  residual_ = without_model(with_row(fit.whitened_measured));
}

Eigen::MatrixXd ModelRemover::without_model(Eigen::MatrixXd columns) const {
  // Twice: the second pass removes what rounding left of the first.
  for (int pass = 0; pass < 2; ++pass) {
    columns -= basis_ * (basis_.transpose() * columns).eval();
  }
  return columns;
}

VisiblePart ModelRemover::operator()(const Eigen::MatrixXd& regressors) const {
  const Eigen::MatrixXd white = with_row(whitening_.apply(regressors));
  VisiblePart part{without_model(white), {}};
  part.visible = part.columns.colwise().norm().transpose();
  for (Eigen::Index i = 0; i < white.cols(); ++i) {
    const double norm = white.col(i).norm();
    part.visible[i] = norm > 0 ? part.visible[i] / norm : 0;
  }
  return part;
}

}  // namespace fogcomp
