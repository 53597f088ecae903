#include "fit/fold.hpp"

#include <algorithm>
#include <limits>

#include "fit/noise_weighted_fit.hpp"
#include "fit/shape_search.hpp"
#include "noise/autocorrelation.hpp"
#include "noise/whitening.hpp"
#include "series/term_columns.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

Eigen::VectorXd weights_without(const Part& left_out, Eigen::VectorXd weights) {
  for (const recording::RowRange& range : left_out) series::of_rows(weights, range).setZero();
  return weights;
}

// If that is wanted, a bias of its own for each power-on that is fitted, but for the first.
Eigen::MatrixXd offsets_of_fitted(const series::Rows& rows, const Eigen::VectorXd& weights,
                                  const JudgedWith& with) {
  if (!with.run_offsets) return Eigen::MatrixXd(rows.size(), 0);
  std::vector<Eigen::MatrixXd> columns;
  bool is_first = true;
  for (const recording::RowRange& power_on : rows.power_ons()) {
    const bool is_fitted = series::of_rows(weights, power_on).any();
    if (is_fitted && !is_first) columns.emplace_back(ones_in(rows, power_on));
    is_first = is_first && !is_fitted;
  }
  return side_by_side(columns, rows.size());
}

// The bias of a power-on that is left out whole is unknown: its mean residual says nothing.
void take_out_unknown_offsets(const series::Rows& rows, const Eigen::VectorXd& fitted,
                              const Eigen::VectorXd& row_weights, Fold& fold) {
  for (const recording::RowRange& power_on : rows.power_ons()) {
    const auto weights = series::of_rows(row_weights, power_on);
    const double weight = weights.sum();
    if (series::of_rows(fitted, power_on).any() || weight <= 0) continue;
    auto residual = series::of_rows(fold.residual_dph, power_on);
    residual.array() -= residual.dot(weights) / weight;
  }
}

// A run that did not excite an effect cannot judge a run that did.
bool determines(const Fold& fold, const Fold& all, Eigen::Index first, Eigen::Index count,
                double much_worse) {
  if (!fold.determined || !all.determined) return false;
  return (fold.sigma_dph.segment(first, count).array() <=
          much_worse * all.sigma_dph.segment(first, count).array())
      .all();
}

}  // namespace

RemainingRows::RemainingRows(const KnownRegressors& known, const Part& left_out,
                             const JudgedWith& with)
    : all(left_out.empty()),
      weights(weights_without(left_out, with.row_weights)),
      whitening(with.noise, known.series().rows(), weights),
      offsets(offsets_of_fitted(known.series().rows(), weights, with)) {}

Fold fit_to(const RemainingRows& remaining, const KnownRegressors& known,
            const std::vector<model::EffectTerm>& terms, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const Eigen::MatrixXd& offsets = remaining.offsets;
  WhitenedProblem problem(known, remaining.whitening, terms, offsets);
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
  search_shapes(problem, shapes, std::vector<bool>(shapes.size(), !remaining.all), false);
  const LinearFit fit = problem.solve();
  Fold fold;
  fold.terms = problem.terms();
  fold.determined = fit.rank == fit.coefficients.size();
  fold.residual_dph = rows.drift_dph;
  Eigen::Index column = 0;
  for (const model::EffectTerm& term : fold.terms) {
    const KnownRegressors::Columns regressors = known(term);
    fold.residual_dph -= *regressors * fit.coefficients.segment(column, regressors->cols());
    column += regressors->cols();
  }
  if (fold.determined) fold.sigma_dph = fit.covariance.diagonal().head(column).cwiseSqrt();
  fold.residual_dph -= offsets * fit.coefficients.tail(offsets.cols());
  if (with.run_offsets) take_out_unknown_offsets(rows, remaining.weights, with.row_weights, fold);
  return fold;
}

Eigen::VectorXd prediction_sigma_dph(const KnownRegressors& known, const Fold& fold,
                                     const RemainingRows& remaining) {
  const series::Rows& rows = known.series().rows();
  const WhitenedProblem problem(known, remaining.whitening, fold.terms, remaining.offsets);
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(fold.terms);
  const LinearFit fit = problem.solve(shapes);
  if (fit.covariance.size() == 0) {
    return Eigen::VectorXd::Constant(rows.size(), std::numeric_limits<double>::infinity());
  }
  std::vector<Eigen::MatrixXd> slopes;
  for (const model::EffectTerm& term : fold.terms) slopes.push_back(*known(term));
  slopes.push_back(remaining.offsets);
  const std::vector<series::ColumnRange> columns = series::columns_of(fold.terms, rows.row_s);
  for (const model::ShapeParameter& shape : shapes) {
    const series::ColumnRange& own = columns[shape.term];
    slopes.emplace_back(problem.derivative(shape, fit.coefficients.segment(own.first, own.count)));
  }
  const Eigen::MatrixXd slope = side_by_side(slopes, rows.size());
  const auto fitted = static_cast<double>((remaining.weights.array() > 0).count());
  const double power =
      std::max(1.0, fit.residual.squaredNorm() / fitted) *
      noise::correlated_values({fit.residual.begin(), fit.residual.end()}, rows.runs());
  return (power * (slope * fit.covariance).cwiseProduct(slope).rowwise().sum())
      .cwiseMax(0)
      .cwiseSqrt();
}

bool determines_all(const Fold& fold, const Fold& all) {
  return determines(fold, all, 0, all.sigma_dph.size(), rules::kFarWorse);
}

bool determines_terms(const Fold& fold, const Fold& all, const KnownRegressors& known,
                      const std::vector<model::EffectTerm>& terms,
                      const std::vector<std::size_t>& asked) {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Eigen::Index count = known(terms[i])->cols();
    const bool is_asked = std::find(asked.begin(), asked.end(), i) != asked.end();
    if (is_asked && !determines(fold, all, first, count, rules::kMuchWorse)) return false;
    first += count;
  }
  return true;
}

bool others_determine(const KnownRegressors& known, const std::vector<model::EffectTerm>& after,
                      const std::vector<std::size_t>& changed, std::size_t run,
                      const JudgedWith& with) {
  const std::vector<model::EffectTerm> terms = model::with_fixed_shapes(after, changed);
  const Fold all = fit_to({known, {}, with}, known, terms, with);
  const Part left_out{known.series().rows().runs()[run]};
  const Fold others = fit_to({known, left_out, with}, known, terms, with);
  return determines_terms(others, all, known, terms, changed);
}

}  // namespace fogcomp::fit
