#include "diagnosis/visible_part.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/decision_rules.hpp"
#include "fit/decision_rules.hpp"
#include "judge/explanations.hpp"
#include "model/catalogue.hpp"
#include "series/row_filters.hpp"
#include "series/term_columns.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr double kRankThreshold = 1e-8;
// Prior knowledge of how exactly the model's terms describe the physics, one standard deviation
// each. Time by which the sensor leads or lags the coil.
constexpr double kSensorDelay_s = 20;
// A part of a term's drift (judge::kInexact) bends with temperature, or follows the heat through a
// coil of many layers with such lags.
constexpr std::array<double, 2> kLags_s{60, 600};
constexpr Eigen::Index kBends = 2;  // orders T and T^2

// Drift of the model's terms, or of those of the temperature rate. Without what the input rate
// does, in which a sensor beside the coil has no part: a sine of the table that were a minute late
// would be all that a scale factor is.
Eigen::VectorXd thermal_drift(const series::Rows& rows, const fit::NoiseWeightedFit& fit,
                              bool of_rate_only) {
  Eigen::VectorXd drift = Eigen::VectorXd::Zero(rows.size());
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  for (std::size_t term = 0; term < columns.size(); ++term) {
    const model::TermInfo info = model::info_of(fit.terms[term]);
    if (has(info.needs, fog::Input::input_rate)) continue;
    for (Eigen::Index i = 0; i < columns[term].count; ++i) {
      const auto& coefficient = info.coefficients[static_cast<std::size_t>(i)];
      if (of_rate_only && !model::of_temperature_rate(coefficient)) continue;
      const Eigen::Index column = columns[term].first + i;
      drift += fit.columns.col(column) * fit.coefficients[column];
    }
  }
  return drift;
}

// d/dt of a series of rows, per second; 0 at the ends of a run.
Eigen::VectorXd slope(const series::Rows& rows, const Eigen::VectorXd& values) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index i = 1; i + 1 < values.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (rows.starts_run(row) || rows.starts_run(row + 1)) continue;
    result[i] = (values[i + 1] - values[i - 1]) / (rows.time_s[row + 1] - rows.time_s[row - 1]);
  }
  return result;
}

// Possible bending of each term: its drift without its mean, times Legendre polynomials of the
// temperature over the range of these rows.
Eigen::MatrixXd bent_terms(const series::Rows& rows, const fit::NoiseWeightedFit& fit) {
  Eigen::ArrayXd degc(rows.size());
  for (Eigen::Index i = 0; i < degc.size(); ++i) {
    degc[i] = rows.signals[static_cast<std::size_t>(i)].temperature;
  }
  const double half_range = std::max((degc.maxCoeff() - degc.minCoeff()) / 2, 1e-9);
  const Eigen::ArrayXd u = (degc - (degc.maxCoeff() + degc.minCoeff()) / 2) / half_range;
  const std::vector<series::ColumnRange> columns = series::columns_of(fit.terms, rows.row_s);
  Eigen::MatrixXd bent(rows.size(), kBends * static_cast<Eigen::Index>(columns.size()));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const auto [first, count] = columns[i];
    Eigen::ArrayXd drift =
        (fit.columns.middleCols(first, count) * fit.coefficients.segment(first, count)).array();
    drift -= drift.mean();
    drift *= judge::kInexact;
    bent.col(at++) = drift * u;
    bent.col(at++) = drift * (3 * u.square() - 1) / 2;
  }
  return bent;
}

// Possible errors of the model's terms, each of one standard deviation.
Eigen::MatrixXd inexact_terms(const series::Rows& rows, const fit::NoiseWeightedFit& fit) {
  const Eigen::VectorXd of_rate = thermal_drift(rows, fit, true);
  Eigen::MatrixXd timings(rows.size(), 1 + kLags_s.size());
  timings.col(0) = kSensorDelay_s * slope(rows, thermal_drift(rows, fit, false));
  for (std::size_t i = 0; i < kLags_s.size(); ++i) {
    timings.col(static_cast<Eigen::Index>(i) + 1) =
        judge::kInexact * (of_rate - series::first_order_lag(rows, of_rate, kLags_s[i]));
  }
  return side_by_side({timings, bent_terms(rows, fit)}, rows.size());
}

}  // namespace

Residualizer::Residualizer(const series::Rows& rows, const fit::NoiseWeightedFit& fit)
    : whitening_(fit.noise, rows, fit.row_weights), inexact_(inexact_terms(rows, fit)) {
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
