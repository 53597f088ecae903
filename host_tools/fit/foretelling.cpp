#include "fit/foretelling.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

#include "fit/inexact_terms.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/predict.hpp"
#include "fit/whitened_problem.hpp"
#include "noise/whitening.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::fit {
namespace {

// An effect alone does not make so many times the drift.
constexpr double kMostOfDrift = 10;

Eigen::MatrixXd inverse(const Eigen::MatrixXd& information) {
  const Eigen::Index size = information.rows();
  return information.llt().solve(Eigen::MatrixXd::Identity(size, size));
}

std::pair<Eigen::Index, Eigen::Index> place_of(const recording::RowRange& range) {
  return {static_cast<Eigen::Index>(range.first), static_cast<Eigen::Index>(range.size())};
}

// Without the rows in which the board's derivative forgets that it began at rest, as a board flags
// them: a recording may begin in a ramp.
Eigen::VectorXd settled(const series::SignalSeries& series, Eigen::VectorXd weights) {
  const series::Rows& rows = series.rows();
  for (const recording::RowRange& power_on : rows.power_ons()) {
    const double from_s = rows.time_s[power_on.first] + series.settling_s();
    for (std::size_t row = power_on.first; row < power_on.end && rows.time_s[row] < from_s; ++row) {
      weights[static_cast<Eigen::Index>(row)] = 0;
    }
  }
  return weights;
}

double rms(const Eigen::VectorXd& values) {
  return values.norm() / std::sqrt(static_cast<double>(values.size()));
}

}  // namespace

Foretelling::Foretelling(const KnownRegressors& known, const JudgedEffects& effects,
                         const JudgedWith& with)
    : drift_dph_(known.series().rows().drift_dph),
      weights_(settled(known.series(), with.row_weights)) {
  const series::Rows& rows = known.series().rows();
  const Eigen::VectorXd coefficients = take_columns(known, effects, with);
  const Eigen::Index linear = coefficients.size();
  const auto shapes = static_cast<Eigen::Index>(model::shape_parameters(effects.terms).size());
  fitted_ = linear + shapes;
  residual_dph_ = drift_dph_ - columns_.leftCols(linear) * coefficients;
  Eigen::VectorXd sigma = Eigen::VectorXd::Ones(columns_.cols());  // beforehand
  sigma.head(linear).setZero();
  sigma.segment(linear, shapes).setConstant(kSigmaOfPosition);
  const noise::Whitening whitening(
      noise_beside({columns_, sigma, linear}, rows, drift_dph_, weights_), rows, weights_);
  slopes_ = whitening.apply(columns_).transpose();
  surprise_ = whitening.apply(residual_dph_);
  sigma_ = whitening.scale().cwiseInverse();
  for (Eigen::Index i = 0; i < linear; ++i) {
    sigma[i] = kMostOfDrift * rms(drift_dph_) / rms(columns_.col(i));
  }
  const Eigen::VectorXd prior = sigma.cwiseAbs2().cwiseInverse();
  information_ = slopes_ * slopes_.transpose();
  information_.diagonal() += prior;
  towards_ = slopes_ * surprise_;
  towards_.head(linear) -= prior.head(linear).cwiseProduct(coefficients);
  const Eigen::VectorXd variances = inverse(information_).diagonal();
  for (Eigen::Index i = linear; i < fitted_; ++i) {
    log_choices_ += std::log(kSigmaOfPosition / std::sqrt(variances[i]));
  }
}

// Returns the coefficients of effects and offsets that fit all rows.
Eigen::VectorXd Foretelling::take_columns(const KnownRegressors& known,
                                          const JudgedEffects& effects, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const std::vector<model::EffectTerm>& terms = effects.terms;
  const Eigen::MatrixXd offsets = run_offset_columns(effects.biases, with.run_offsets);
  const noise::Whitening whitening(with.noise, rows, weights_);
  const WhitenedProblem problem(known, whitening, terms, offsets);
  const Eigen::VectorXd coefficients = problem.solve().coefficients;
  std::vector<Eigen::MatrixXd> parts;
  for (const model::EffectTerm& term : terms) parts.push_back(*known(term));
  parts.push_back(offsets);
  const std::vector<series::ColumnRange> places = series::columns_of(terms, rows.row_s);
  for (const model::ShapeParameter& shape : model::shape_parameters(terms)) {
    const series::ColumnRange& own = places[shape.term];
    parts.emplace_back(problem.derivative(shape, coefficients.segment(own.first, own.count)));
  }
  parts.push_back(
      inexact_terms(rows, terms, side_by_side(parts, rows.size()), coefficients, with.refined));
  columns_ = side_by_side(parts, rows.size());
  return coefficients;
}

void Foretelling::OfPart::join(const OfPart& other) {
  const auto is_others = other.rows.variance.array() > 0;
  rows.mean_dph = is_others.select(other.rows.mean_dph, rows.mean_dph);
  rows.variance += other.rows.variance;
  residual_dph += other.residual_dph;
  promise.add(other.promise);
}

bool Foretelling::can_foretell(const Part& part) const {
  return std::any_of(part.begin(), part.end(), [&](const recording::RowRange& range) {
    const auto [first, size] = place_of(range);
    return (weights_.segment(first, size).array() > 0).any();
  });
}

Foretelling::OfPart Foretelling::of(const Part& part) const {
  Eigen::MatrixXd information = information_;
  Eigen::VectorXd towards = towards_;
  for (const recording::RowRange& range : part) {
    const auto [first, size] = place_of(range);
    const auto left_out = slopes_.middleCols(first, size);
    information -= left_out * left_out.transpose();
    towards -= left_out * surprise_.segment(first, size);
  }
  Unknowns unknowns{Eigen::VectorXd(), inverse(information)};
  unknowns.change = unknowns.covariance * towards;
  OfPart foretold{{drift_dph_, Eigen::VectorXd::Zero(drift_dph_.size())},
                  Eigen::VectorXd::Zero(drift_dph_.size()),
                  promise_of(part, (information_ - information) * unknowns.covariance)};
  for (const recording::RowRange& range : part) {
    const auto [first, size] = place_of(range);
    foretold.residual_dph.segment(first, size) =
        residual_dph_.segment(first, size) -
        columns_.middleRows(first, size).leftCols(fitted_) * unknowns.change.head(fitted_);
    foretold.promise.squares += (surprise_.segment(first, size) -
                                 slopes_.middleCols(first, size).transpose() * unknowns.change)
                                    .squaredNorm();
  }
  for (const recording::RowRange& range : part) foretell(range, unknowns, foretold.rows);
  return foretold;
}

// `of_unknowns`: the rows' information of the unknowns times their covariance without these rows.
judge::Promise Foretelling::promise_of(const Part& part, const Eigen::MatrixXd& of_unknowns) const {
  judge::Promise promise;
  for (const recording::RowRange& range : part) {
    const auto [first, size] = place_of(range);
    promise.expected += (weights_.segment(first, size).array() > 0).cast<double>().sum();
  }
  const double by_unknowns = of_unknowns.trace();
  promise.variance = 2 * promise.expected + 4 * by_unknowns +
                     2 * of_unknowns.cwiseProduct(of_unknowns.transpose()).sum();
  promise.expected += by_unknowns;
  return promise;
}

// Recursive least squares: each row, once it is foretold, tells of the next.
void Foretelling::foretell(const recording::RowRange& range, Unknowns& unknowns,
                           judge::Foretold& rows) const {
  const auto [first, size] = place_of(range);
  for (Eigen::Index row = first; row < first + size; ++row) {
    if (weights_[row] <= 0) continue;
    const Eigen::VectorXd gain = unknowns.covariance * slopes_.col(row);
    const double variance = 1 + slopes_.col(row).dot(gain);
    const double surprise = surprise_[row] - slopes_.col(row).dot(unknowns.change);
    rows.mean_dph[row] -= surprise * sigma_[row];
    rows.variance[row] = variance * sigma_[row] * sigma_[row];
    unknowns.change += gain * (surprise / variance);
    unknowns.covariance -= gain * gain.transpose() / variance;
  }
}

}  // namespace fogcomp::fit
