#include "numerics/least_squares.hpp"

#include <Eigen/QR>

namespace fogcomp {

LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values) {
  // Unit columns, so that rank and conditioning do not depend on units.
  Eigen::VectorXd norms = matrix.colwise().norm().transpose();
  norms = norms.unaryExpr([](double norm) { return norm > 0 ? norm : 1.0; });
  const Eigen::VectorXd scale = norms.cwiseInverse();

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(kLeastPivot);
  qr.compute(matrix * scale.asDiagonal());

  LinearFit fit;
  fit.rank = qr.rank();
  fit.coefficients = scale.cwiseProduct(qr.solve(values));
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
  const Eigen::MatrixXd basis = orthonormal(instruments, kLeastPivot);
  if (basis.cols() < matrix.cols()) return solve_linear(matrix, values);
  LinearFit fit = solve_linear(basis.transpose() * matrix, basis.transpose() * values);
  fit.residual = values - matrix * fit.coefficients;
  return fit;
}

Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns, double rank_threshold) {
  Eigen::VectorXd scale = columns.colwise().norm().transpose();
  scale = scale.unaryExpr([](double norm) { return norm > 0 ? 1 / norm : 1.0; });
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(rank_threshold);
  qr.compute(columns * scale.asDiagonal());
  return qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
}

Eigen::MatrixXd side_by_side(const std::vector<Eigen::MatrixXd>& parts, Eigen::Index rows) {
  Eigen::Index width = 0;
  for (const Eigen::MatrixXd& part : parts) width += part.cols();
  Eigen::MatrixXd all(rows, width);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

}  // namespace fogcomp
