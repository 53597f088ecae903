#include "fit/identify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fit/decision_rules.hpp"
#include "fit/expression_survey.hpp"
#include "fit/gyro_fit.hpp"
#include "fit/informed_fit.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/predict.hpp"
#include "fit/reference_values.hpp"
#include "fit/soak_uncertainty.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "fit/undetermined.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"
#include "noise/outlier_rows.hpp"
#include "series/term_columns.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// Largest correlation between a coefficient of one effect and a coefficient of the other.
double correlation(const Eigen::MatrixXd& covariance, const series::ColumnRange& a,
                   const series::ColumnRange& b) {
  double largest = 0;
  for (Eigen::Index i = a.first; i < a.first + a.count; ++i) {
    for (Eigen::Index j = b.first; j < b.first + b.count; ++j) {
      largest = std::max(
          largest, std::abs(covariance(i, j)) / std::sqrt(covariance(i, i) * covariance(j, j)));
    }
  }
  return largest;
}

std::vector<std::string> confusions(const std::vector<model::EffectTerm>& terms,
                                    const std::vector<series::ColumnRange>& columns,
                                    const Eigen::MatrixXd& covariance) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const double rho = correlation(covariance, columns[i], columns[j]);
      if (rho < rules::kConfused) continue;
      warnings.push_back(
          format("`%s` and `%s` are %.2f correlated on these data: their sum is known, "
                 "their split is not",
                 terms[i].name.c_str(), terms[j].name.c_str(), rho));
    }
  }
  return warnings;
}

template <class Value>
model::Range range_of(std::size_t count, Value value_at) {
  model::Range range{value_at(0), value_at(0)};
  for (std::size_t i = 1; i < count; ++i) {
    range.min = std::min(range.min, value_at(i));
    range.max = std::max(range.max, value_at(i));
  }
  return range;
}

void set_ranges(model::Model& model, const series::Rows& rows) {
  const std::size_t count = rows.signals.size();
  const model::Range degc =
      range_of(count, [&](std::size_t i) { return rows.signals[i].temperature; });
  model.min_degc = degc.min - rules::kRangeMarginDegc;
  model.max_degc = degc.max + rules::kRangeMarginDegc;
  model.rate_range_degc_per_min =
      range_of(count, [&](std::size_t i) { return rows.signals[i].temperature_rate; });
  model.time_range_s = range_of(count, [&](std::size_t i) { return rows.time_s[i]; });
  model.input_ranges = rows.input_ranges;
  model.input_rate_range_dph.reset();
  if (!has(model::needs_of(model), fog::Input::input_rate)) return;
  model.input_rate_range_dph =
      range_of(count, [&](std::size_t i) { return rows.inputs[i].input_rate; });
}

void set_noise_and_residual(const series::Rows& rows, const NoiseWeightedFit& fit,
                            Identification& result) {
  result.residual_dph = fit.residual_dph;
  result.noise = fit.noise;
  result.birge_ratio = fit.birge_ratio();
  result.masked = static_cast<std::size_t>((rows.weights.array() <= 0).count());
  // What is left is stated of all rows, as in a comparison, in which a derivative settles, too.
  result.row_weights = fit.weights_of(rows, noise::counted_rows(rows));
  result.outliers = fit.outliers;
}

// Column of the model's bias; nothing if it has none.
std::optional<Eigen::Index> bias_column(const std::vector<model::EffectTerm>& terms,
                                        const std::vector<series::ColumnRange>& columns) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (terms[i].name == "bias") return columns[i].first;
  }
  return std::nullopt;
}

// A fit whose power-ons each have a bias of their own, and its covariance, for biases that spread
// as these do. The model has the mean of those that the gyro went on with: the bias of a power-on
// is any of them by chance.
void set_offsets(const BiasColumns& columns, NoiseWeightedFit& fit, Eigen::MatrixXd& covariance,
                 Identification& result) {
  const auto [first, count] = columns.offsets;
  if (count == 0) return;
  result.turn_on_repeatability_dph = turn_on_repeatability(fit, columns.offsets, covariance).dph;
  expect_repeatability(result.turn_on_repeatability_dph, columns, fit, covariance);
  const auto offsets = fit.coefficients.segment(first, count);
  result.run_offsets_dph.assign(offsets.begin(), offsets.end());
  if (columns.bias) fit.coefficients[*columns.bias] += offsets.dot(columns.shares.tail(count));
}

// Copies a term's coefficients and their uncertainties from a fit. Returns the peak, deg/h, that
// the effect needs to be certainly visible.
double set_coefficients(model::EffectTerm& term, const series::ColumnRange& columns,
                        const NoiseWeightedFit& fit, const Eigen::MatrixXd& covariance) {
  const auto [first, count] = columns;
  const auto values = fit.coefficients.segment(first, count);
  if (values.cwiseAbs().maxCoeff() > model::kMaxModelDph) {
    throw InputError(term.name, format("its coefficient would be %.2g deg/h: the effect is next to "
                                       "nothing on these recordings; leave it out",
                                       values.cwiseAbs().maxCoeff()));
  }
  const Eigen::MatrixXd own = covariance.block(first, first, count, count);
  term.coefficients_dph.clear();
  for (Eigen::Index i = 0; i < count; ++i) {
    term.coefficients_dph.emplace_back(values[i], std::sqrt(own(i, i)));
  }
  const Eigen::MatrixXd part = fit.columns.middleCols(first, count);
  return kCertainSigmas * std::sqrt((part * own).cwiseProduct(part).rowwise().sum().maxCoeff());
}

void set_shape_sigmas(std::vector<model::EffectTerm>& terms, const NoiseWeightedFit& fit,
                      const Eigen::VectorXd& sigma) {
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    const model::ShapeParameter& shape = fit.shapes[i];
    model::Parameter& parameter = terms[shape.term].parameters[shape.index];
    parameter.sigma =
        sigma[fit.linear() + static_cast<Eigen::Index>(i)] * shape.slope(parameter.value);
  }
}

void set_gyro(model::Model& model, const std::optional<GyroFit>& gyro) {
  model.uncertainty.reset();
  for (model::EffectTerm& term : model.terms) term.gyro.reset();
  if (!gyro) return;
  model.uncertainty = gyro->uncertainty;
  for (std::size_t i = 0; i < model.terms.size(); ++i) model.terms[i].gyro = gyro->terms[i];
}

// If the worst uncertainty of the drift in a soak or at power-on exceeds what the drift does about
// its mean, warns that a constant would be as good.
void judge_uncertainty(model::Model& model, const NoiseWeightedFit& fit,
                       const Eigen::MatrixXd& covariance, const series::Rows& rows,
                       Identification& result) {
  const double mean_dph = rows.drift_dph.dot(rows.weights) / rows.weights.sum();
  const double drift_dph = weighted_rms(rows.drift_dph.array() - mean_dph, rows.weights);
  model.uncertain.reset();
  const bool needs_time = has(model::needs_of(model), fog::Input::elapsed);
  for (const bool at_power_on : {false, true}) {
    if (at_power_on && !needs_time) return;
    SoakUncertainty worst = soak_uncertainty(model, fit, covariance, rows, at_power_on);
    if (!at_power_on) result.soak_sigma_dph = worst.sigma_dph;
    if (worst.sigma_dph <= drift_dph) continue;
    worst.sigma_dph = std::min(worst.sigma_dph, model::kMaxModelDph);  // larger ones mean the same
    model.uncertain = model::Model::Uncertain{worst.sigma_dph, drift_dph, at_power_on};
    result.warnings.push_back(format("at %.4g degC ", worst.at_degc) + model.uncertain->words());
    return;
  }
}

// A drift without any noise divides by zero, and squares end at 1e308.
void require_finite(const model::Model& model) {
  Eigen::Index at = 0;
  for (const model::EffectTerm& term : model.terms) {
    bool finite = true;
    for (const model::Estimate& coefficient : term.coefficients_dph) {
      finite = finite && std::isfinite(coefficient.value) && std::isfinite(coefficient.sigma) &&
               (!model.uncertainty || model.uncertainty->covariance.row(at).allFinite());
      ++at;
    }
    if (finite) continue;
    throw InputError(term.name,
                     "has no finite coefficient: the drift does not move at all, or the effect's "
                     "values are too large or too small to calculate with; leave it out");
  }
}

void set_expression_scales(model::Model& model, const series::SignalSeries& series) {
  Eigen::Index at = 0;
  for (model::EffectTerm& term : model.terms) {
    const double rise = std::ldexp(1, set_expression_scale(term, series));
    if (model.uncertainty && term.expression) {
      model.uncertainty->covariance.row(at) *= rise;
      model.uncertainty->covariance.col(at) *= rise;
    }
    at += static_cast<Eigen::Index>(term.coefficients_dph.size());
  }
}

// Warnings about the whole model, and its residual.
void judge_model(model::Model& model, const NoiseWeightedFit& fit,
                 const series::SignalSeries& series, Identification& result) {
  const series::Rows& rows = series.rows();
  for (const model::EffectTerm& term : model.terms) {
    for (const std::string& doubt : model::shape_doubts(term)) result.warnings.push_back(doubt);
  }
  const Eigen::MatrixXd of_noise = std::pow(std::max(1.0, result.birge_ratio), 2) * fit.covariance;
  judge_uncertainty(model, fit, of_noise, rows, result);
  set_expression_scales(model, series);
  const Eigen::VectorXd counted = noise::counted_weights(rows, result.row_weights);
  model.residual_rms_dph = std::sqrt(result.residual_dph.cwiseAbs2().dot(counted) / counted.sum());
}

// How much of each bias is in the model's: all of it that a power-on ends with, in equal shares.
Eigen::VectorXd shares_of_biases(const series::Rows& rows) {
  const std::vector<recording::RowRange> biases = rows.bias_ranges();
  Eigen::VectorXd shares(static_cast<Eigen::Index>(biases.size()));
  for (std::size_t i = 0; i < biases.size(); ++i) {
    shares[static_cast<Eigen::Index>(i)] = rows.is_cut_at(biases[i].end) ? 0 : 1;
  }
  return shares / shares.sum();
}

// The signals of an expression may be where either has seen them.
void widen_ranges(const model::EffectTerm& seen, model::EffectTerm& term) {
  if (!term.expression) return;
  for (std::size_t i = 0; i < term.expression->ranges.size(); ++i) {
    model::SignalRange& range = term.expression->ranges[i];
    const model::SignalRange& other = seen.expression->ranges[i];
    range = {std::min(range.min, other.min), std::max(range.max, other.max)};
  }
}

// To what a board reads, and to the gyro's own temperature.
struct BothFits {
  NoiseWeightedFit board;
  NoiseWeightedFit gyro;
};

// RowSettings::kept: a bias of its own for each power-on would be what the derivative lacks until
// it has settled.
Eigen::VectorXd beside_biases(const series::SignalSeries& series, const Eigen::MatrixXd& offsets) {
  const series::Rows& rows = series.rows();
  if (offsets.cols() == 0 || rows.power_ons().size() < 2) return {};
  const bool any = series.settled().cwiseProduct(rows.weights).maxCoeff() > 0;
  return any ? series.settled() : Eigen::VectorXd();
}

// Shapes are searched with the gyro's own temperature, which takes a fifth of the time. With what a
// board reads they are near the same minimum.
BothFits fit_without_prior(const KnownRegressors& known,
                           const std::vector<model::EffectTerm>& terms,
                           const Eigen::MatrixXd& offsets, const IdentifySettings& settings) {
  BothFits both;
  RowSettings search;
  search.progress = settings.progress;
  both.gyro = fit_rows(known.of(series::Reading::of_gyro), terms, offsets, search);
  RowSettings found;
  found.shapes_found = true;
  found.kept = beside_biases(known.series(), offsets);
  both.board = fit_determined(known, both.gyro.terms, offsets, found);
  return both;
}

BothFits both_fits(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                   const Eigen::MatrixXd& offsets, const IdentifySettings& settings,
                   Identification& result) {
  if (!settings.prior) return fit_without_prior(known, terms, offsets, settings);
  Prior prior = *settings.prior;
  for (std::size_t i = 0; i < terms.size(); ++i) widen_ranges(terms[i], prior.terms[i]);
  InformedFit found = fit_with_prior(known, prior, offsets, settings.progress);
  result.prior = settings.prior;
  result.departures = std::move(found.departures);
  RowSettings again{found.fit.robust, found.fit.noise};
  again.prior = &*found.fit.prior;
  NoiseWeightedFit gyro =
      fit_rows(known.of(series::Reading::of_gyro), found.fit.terms, offsets, again);
  return {std::move(found.fit), std::move(gyro)};
}

}  // namespace

Identification identify(model::Model& model, const KnownRegressors& known,
                        const IdentifySettings& settings) {
  const series::SignalSeries& series = known.series();
  const series::Rows& rows = series.rows();
  require_varying_input_rate(model.terms, rows);
  set_references(model.terms, series);
  set_expression_ranges(model.terms, series);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, settings.run_offsets);
  Identification result;
  auto [fit, own] = both_fits(known, model.terms, offsets, settings, result);
  model.terms = fit.terms;

  // order: coefficients, offsets of all biases but the first
  const std::vector<series::ColumnRange> columns = series::columns_of(model.terms, rows.row_s);
  const Eigen::Index behind = columns.back().first + columns.back().count;
  const series::ColumnRange offset_columns{behind, offsets.cols()};
  const std::optional<GyroFit> gyro = values_of_gyro(known, own, offset_columns);
  Eigen::MatrixXd covariance = predict(rows, fit).covariance();
  set_offsets({bias_column(model.terms, columns), offset_columns, shares_of_biases(rows)}, fit,
              covariance, result);
  set_noise_and_residual(rows, fit, result);
  const Eigen::VectorXd sigma = covariance.diagonal().cwiseSqrt();
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    result.visible_dph.push_back(set_coefficients(model.terms[i], columns[i], fit, covariance));
  }
  set_shape_sigmas(model.terms, fit, sigma);
  set_gyro(model, gyro);
  result.warnings = confusions(model.terms, columns, fit.covariance);
  set_ranges(model, rows);
  judge_model(model, fit, series, result);
  require_finite(model);
  return result;
}

double PriorUpdate::from_before() const {
  return departure.is_certain() ? 0 : std::min(1.0, std::pow(after.sigma / before.sigma, 2));
}

std::vector<PriorUpdate> prior_updates(const model::Model& model,
                                       const Identification& identified) {
  const Prior& prior = *identified.prior;
  const std::vector<std::string> names = names_of_unknowns(prior.terms);
  const auto sigma = [&](std::size_t at) {
    const auto i = static_cast<Eigen::Index>(at);
    return std::sqrt(prior.covariance(i, i));
  };
  std::vector<PriorUpdate> all;
  for (const model::EffectTerm& term : model.terms) {
    const model::TermInfo info = model::info_of(term);
    for (std::size_t k = 0; k < term.coefficients_dph.size(); ++k) {
      const std::size_t i = all.size();
      const double mean = prior.gyro_mean[static_cast<Eigen::Index>(i)];
      all.push_back({names[i],
                     info.coefficients[k].unit,
                     {model::in_natural_unit(mean, info.coefficients[k]),
                      std::abs(model::in_natural_unit(sigma(i), info.coefficients[k]))},
                     model::natural_coefficient(term, k),
                     identified.departures[i]});
    }
  }
  for (const model::ShapeParameter& shape : model::shape_parameters(model.terms)) {
    const std::size_t i = all.size();
    const double value = shape.from_unit(prior.gyro_mean[static_cast<Eigen::Index>(i)]);
    const model::EffectTerm& term = model.terms[shape.term];
    all.push_back({names[i],
                   model::info_of(term).parameters[shape.index].unit,
                   {value, sigma(i) * shape.slope(value)},
                   model::shape_value(term, shape.index),
                   identified.departures[i]});
  }
  return all;
}

}  // namespace fogcomp::fit
