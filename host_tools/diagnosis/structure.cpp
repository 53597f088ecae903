#include "diagnosis/structure.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/thermal/play.hpp"
#include "diagnosis/decision_rules.hpp"
#include "fit/decision_rules.hpp"
#include "fit/inexact_terms.hpp"
#include "model/input_value.hpp"
#include "series/rows.hpp"
#include "support/decompositions.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr int kTemperatureKnots = 8;
constexpr int kRateKnots = 6;
constexpr int kTimeKnots = 8;  // per run
constexpr int kMaxTimeKnots = 32;

Eigen::VectorXd column_of(
    const series::Rows& rows,
    const std::function<double(const fog::Signals<model::RealNumbers>&)>& value) {
  Eigen::VectorXd column(rows.size());
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    column[i] = value(rows.signals[static_cast<std::size_t>(i)]);
  }
  return column;
}

// Cubic B-splines over the range of x with equidistant knots: smooth, local, with sum 1.
Eigen::MatrixXd smooths(const Eigen::VectorXd& x, int knots) {
  const double min = x.minCoeff();
  const double step = (x.maxCoeff() - min) / (knots - 1);
  Eigen::MatrixXd columns(x.size(), step > 0 ? knots : 0);
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    columns.col(k) = x.unaryExpr([&](double value) {
      const double u = std::abs((value - min) / step - static_cast<double>(k));
      if (u >= 2) return 0.0;
      return u < 1 ? 2.0 / 3 - u * u + u * u * u / 2 : std::pow(2 - u, 3) / 6;
    });
  }
  return columns;
}

Eigen::VectorXd beyond_play(const series::Rows& rows, const Eigen::VectorXd& x, double radius) {
  fog::Play<model::RealNumbers> play(radius);
  Eigen::VectorXd beyond(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (rows.starts_run(static_cast<std::size_t>(i))) {
      play = fog::Play<model::RealNumbers>(radius);
      play.start(x[i]);
    }
    beyond[i] = play.step(x[i]);
  }
  return beyond;
}

}  // namespace

Eigen::MatrixXd smooths_in_time(const series::Rows& rows) {
  const auto runs = static_cast<int>(rows.run_starts.size());
  const int knots = std::clamp(kMaxTimeKnots / runs, 3, kTimeKnots);
  std::vector<Eigen::MatrixXd> parts;
  for (const recording::RowRange& run : rows.runs()) {
    const auto first = static_cast<Eigen::Index>(run.first);
    const auto count = static_cast<Eigen::Index>(run.size());
    const Eigen::VectorXd time = Eigen::Map<const Eigen::VectorXd>(&rows.time_s[run.first], count);
    Eigen::MatrixXd here = smooths(time, knots);
    Eigen::MatrixXd part = Eigen::MatrixXd::Zero(rows.size(), here.cols());
    part.middleRows(first, count) = here;
    parts.push_back(std::move(part));
  }
  return side_by_side(parts, rows.size());
}

Eigen::VectorXd temperature_beyond(const series::Rows& rows, const Eigen::VectorXd& temperature,
                                   const TemperatureHistory& history) {
  if (history.is_play) return beyond_play(rows, temperature, history.parameter);
  return temperature - series::first_order_lag(rows, temperature, history.parameter);
}

std::vector<StructureGroup> structure_groups(const series::Rows& rows) {
  const Eigen::VectorXd temperature = column_of(rows, [](const auto& s) { return s.temperature; });
  const Eigen::VectorXd rate = column_of(rows, [](const auto& s) { return s.temperature_rate; });
  std::vector<StructureGroup> groups;
  groups.push_back({"temperature_degc", smooths(temperature, kTemperatureKnots)});
  groups.push_back({"temperature_rate", smooths(rate, kRateKnots)});
  // How the drift depends on the rate may vary with temperature as freely as the drift itself.
  const Eigen::MatrixXd product = smooths(temperature, kTemperatureKnots);
  groups.push_back(
      {"temperature_degc x temperature_rate",
       side_by_side({rate.asDiagonal() * product, rate.cwiseAbs2().cwiseProduct(temperature)},
                    rows.size())});
  std::vector<Eigen::MatrixXd> history;
  for (const TemperatureHistory& each : kTemperatureHistories) {
    history.push_back(temperature_beyond(rows, temperature, each));
  }
  groups.push_back({"temperature history", side_by_side(history, rows.size())});
  groups.push_back({"time_s", smooths_in_time(rows)});

  for (std::size_t i = static_cast<std::size_t>(fog::Input::input_rate); i < fog::kInputs; ++i) {
    const fog::InputDescription& input = fog::kInputTable[i];
    const Eigen::VectorXd values =
        column_of(rows, [&](const auto& s) { return model::optional_input(input.input, s.block); });
    if (!(values.maxCoeff() > values.minCoeff())) continue;
    const Eigen::VectorXd x = values.array() - values.mean();
    groups.push_back(
        {input.column, side_by_side({x, x.cwiseAbs2(), x.cwiseProduct(temperature)}, rows.size())});
  }
  return groups;
}

namespace {

// Orthonormal directions of the columns that are not practically invisible.
Eigen::MatrixXf principal(const Eigen::MatrixXd& columns) {
  constexpr double kMin = 1e-3;  // norm relative to a unit column
  const SymmetricEigen eigen = symmetric_eigen(gram(columns));
  Eigen::Index kept = 0;
  while (kept < columns.cols() && eigen.values[columns.cols() - 1 - kept] > kMin) ++kept;
  const Eigen::MatrixXd directions = eigen.vectors.rightCols(kept);
  const Eigen::VectorXd scale = eigen.values.tail(kept).cwiseSqrt().cwiseInverse();
  return (columns * directions * scale.asDiagonal()).cast<float>();
}

}  // namespace

VisibleStructure visible_structure(const series::Rows& rows, const Residualizer& residualizer) {
  VisibleStructure structure;
  std::vector<Eigen::MatrixXd> parts;
  structure.raw = structure_groups(rows);
  for (const StructureGroup& group : structure.raw) {
    const VisiblePart part = residualizer(group.columns);
    Eigen::MatrixXd kept(part.columns.rows(), part.columns.cols());
    Eigen::Index count = 0;
    for (Eigen::Index i = 0; i < part.columns.cols(); ++i) {
      constexpr double kVisibleColumn = 0.01;
      if (part.visible[i] > kVisibleColumn) kept.col(count++) = part.columns.col(i).normalized();
    }
    if (count == 0) continue;
    structure.variables.push_back(group.variable);
    structure.groups.push_back(principal(kept.leftCols(count)));
    parts.push_back(kept.leftCols(count));
  }
  structure.all = principal(side_by_side(parts, residualizer.residual().size()));
  return structure;
}

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
  basis_ = orthonormal(columns, kRank);
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
