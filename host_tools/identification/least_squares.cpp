#include "identification/least_squares.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace fogcomp {
namespace {

// Columns further down than this in the pivots are noise of the arithmetic.
constexpr double kRankThreshold = 1e-10;

}  // namespace

LinearFit solve_linear(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& values,
                       const Eigen::VectorXd& weights) {
  const Eigen::VectorXd root = weights.cwiseSqrt();
  Eigen::MatrixXd scaled = root.asDiagonal() * matrix;
  // Unit columns, so that rank and conditioning do not depend on units.
  Eigen::VectorXd norms = scaled.colwise().norm().transpose();
  norms = norms.unaryExpr([](double norm) { return norm > 0 ? norm : 1.0; });
  scaled = scaled * norms.cwiseInverse().asDiagonal();

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(kRankThreshold);
  qr.compute(scaled);

  LinearFit fit;
  fit.rank = qr.rank();
  fit.coefficients = qr.solve(root.cwiseProduct(values)).cwiseQuotient(norms);
  fit.residual = values - matrix * fit.coefficients;
  const double chi2 = fit.residual.cwiseProduct(root).squaredNorm();
  fit.rms = std::sqrt(chi2 / weights.sum());
  fit.sigma = Eigen::VectorXd::Constant(matrix.cols(), std::nan(""));
  if (fit.rank == matrix.cols()) {
    const double freedom = static_cast<double>(std::max<Eigen::Index>(1, matrix.rows() - fit.rank));
    const Eigen::MatrixXd r = qr.matrixQR().topRows(fit.rank).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd inverse =
        r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(fit.rank, fit.rank));
    const Eigen::VectorXd unit_sigma = qr.colsPermutation() * inverse.rowwise().norm().eval();
    fit.sigma = (unit_sigma * std::sqrt(chi2 / freedom)).cwiseQuotient(norms);
  }
  return fit;
}

}  // namespace fogcomp
