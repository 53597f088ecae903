#include "diagnosis/visible_part.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/decision_rules.hpp"
#include "fit/decision_rules.hpp"
#include "fit/inexact_terms.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kRankThreshold = 1e-8;

}  // namespace

Residualizer::Residualizer(const series::Rows& rows, const fit::NoiseWeightedFit& fit)
    : whitening_(fit.noise, rows, fit.row_weights),
      inexact_(fit::inexact_terms(rows, fit.terms, fit.columns, fit.coefficients)) {
  priors_ = inexact_.cols();
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(rows.size() + priors_, fit.whitened.cols() + priors_);
  columns.topLeftCorner(rows.size(), fit.whitened.cols()) = fit.whitened;
  columns.topRightCorner(rows.size(), priors_) = whitening_.apply(inexact_);
  // With a residual far above noise the rows determine these less well than their noise suggests.
  const auto size = static_cast<double>(rows.size());
  const double excess = std::max(0.0, fit.whitened_residual.squaredNorm() - size);
  columns.bottomRightCorner(priors_, priors_)
      .diagonal()
      .setConstant(std::sqrt(1 + fit::rules::kModelFormTolerance * excess));
  basis_ = orthonormal(columns, kRankThreshold);
  residual_ = without_model(with_priors(fit.whitened_measured));
}

Eigen::MatrixXd Residualizer::with_priors(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd longer = Eigen::MatrixXd::Zero(columns.rows() + priors_, columns.cols());
  longer.topRows(columns.rows()) = columns;
  return longer;
}

// Repeated if rounding errors are a large part of the result.
Eigen::MatrixXd Residualizer::without_model(const Eigen::MatrixXd& columns) const {
  constexpr double kLittle = 1e-2;
  Eigen::MatrixXd left = projected_out(basis_, columns);
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    if (left.col(i).norm() > kLittle * columns.col(i).norm()) continue;
    left.col(i) = projected_out(basis_, left.col(i));
  }
  return left;
}

Eigen::MatrixXd Residualizer::chi2_drops_of_steps(const series::Rows& rows,
                                                  const Eigen::MatrixXd& left) const {
  Eigen::MatrixXd columns(rows.size(), left.cols() + basis_.cols());
  columns << left.topRows(rows.size()), basis_.topRows(rows.size());
  const noise::StepProducts steps = whitening_.steps(rows, columns);
  const Eigen::ArrayXd visible =
      steps.square.array() - steps.with.rightCols(basis_.cols()).rowwise().squaredNorm().array();
  const double min_share = rules::kMinVisible * rules::kMinVisible;
  const Eigen::ArrayXd per_square =
      (visible > min_share * steps.square.array()).select(visible.max(1e-300).inverse(), 0);
  return steps.with.leftCols(left.cols()).array().square().colwise() * per_square;
}

VisiblePart Residualizer::operator()(const Eigen::MatrixXd& regressors) const {
  const Eigen::MatrixXd white = with_priors(whitening_.apply(regressors));
  VisiblePart part{without_model(white), {}};
  part.visible = part.columns.colwise().norm().transpose();
  for (Eigen::Index i = 0; i < white.cols(); ++i) {
    const double norm = white.col(i).norm();
    part.visible[i] = norm > 0 ? part.visible[i] / norm : 0;
  }
  return part;
}

}  // namespace fogcomp::diagnosis
