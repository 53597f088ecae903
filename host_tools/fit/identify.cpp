#include "fit/identify.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fit/coefficient_covariance.hpp"
#include "fit/expression_survey.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/soak_uncertainty.hpp"
#include "fit/step_search.hpp"
#include "model/catalogue.hpp"
#include "model/model_file.hpp"
#include "model/shape_limits.hpp"
#include "noise/outlier_rows.hpp"
#include "series/term_columns.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp {
namespace {

// Beyond the coldest and warmest training row, so that sensor noise at the end of a range is not
// yet outside it.
constexpr double kRangeMarginDegc = 1;
constexpr double kConfused = 0.95;  // correlation of two effects' coefficients worth a sentence
constexpr double kVisible = 5;      // standard deviations
constexpr double kRampDegcPerMin = 0.1;

// Largest correlation between any coefficient of one effect and any of the other.
double correlation(const Eigen::MatrixXd& covariance, const ColumnRange& a, const ColumnRange& b) {
  double largest = 0;
  for (Eigen::Index i = a.first; i < a.first + a.count; ++i) {
    for (Eigen::Index j = b.first; j < b.first + b.count; ++j) {
      largest = std::max(
          largest, std::abs(covariance(i, j)) / std::sqrt(covariance(i, i) * covariance(j, j)));
    }
  }
  return largest;
}

std::vector<std::string> confusions(const std::vector<EffectTerm>& terms,
                                    const std::vector<ColumnRange>& columns,
                                    const Eigen::MatrixXd& covariance) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const double rho = correlation(covariance, columns[i], columns[j]);
      if (rho < kConfused) continue;
      warnings.push_back(
          format("`%s` and `%s` are %.2f correlated on these data: their sum is known, "
                 "their split is not",
                 terms[i].name.c_str(), terms[j].name.c_str(), rho));
    }
  }
  return warnings;
}

template <class Value>
Range range_of(std::size_t count, Value value_at) {
  Range range{value_at(0), value_at(0)};
  for (std::size_t i = 1; i < count; ++i) {
    range.least = std::min(range.least, value_at(i));
    range.most = std::max(range.most, value_at(i));
  }
  return range;
}

void set_ranges(Model& model, const Rows& rows) {
  const std::size_t count = rows.signals.size();
  const Range degc = range_of(count, [&](std::size_t i) { return rows.signals[i].temperature; });
  model.least_degc = degc.least - kRangeMarginDegc;
  model.most_degc = degc.most + kRangeMarginDegc;
  model.rate_range_degc_per_min =
      range_of(count, [&](std::size_t i) { return rows.signals[i].temperature_rate; });
  model.time_range_s = range_of(count, [&](std::size_t i) { return rows.time_s[i]; });
  model.input_ranges = rows.input_ranges;
}

bool is_sought(const EffectTerm& term) {
  return is_event(term) && term.identified[0];
}

// A step without its time leaves the list: it has no regressors before it is found.
std::optional<EffectTerm> take_out_step(std::vector<EffectTerm>& terms) {
  const auto sought = std::find_if(terms.begin(), terms.end(), is_sought);
  if (sought == terms.end()) return std::nullopt;
  EffectTerm step = std::move(*sought);
  terms.erase(sought);
  if (terms.empty()) {
    throw InputError("--effects", "names no effect beside " + step.name + "; add bias");
  }
  return step;
}

// A step as a term of the model and as an event of its recording.
void add_step(Model& model, Identification& result, const Rows& rows, const ChangePoint& change,
              EffectTerm step) {
  const double sigma_dph = step.sigma_dph[0];
  result.steps.push_back({rows.run_at(static_cast<std::size_t>(change.row)), change.time_s,
                          change.time_sigma_s, step.coefficients_dph[0], sigma_dph});
  step.parameters = {change.time_s};
  step.parameter_sigma = {change.time_sigma_s};
  model.terms.push_back(std::move(step));
  result.visible_dph.push_back(kVisible * sigma_dph);
  const auto& signals = rows.signals[static_cast<std::size_t>(change.row)];
  if (std::abs(signals.temperature_rate) < kRampDegcPerMin) return;
  result.warnings.push_back(
      format("the bias step at %.6g s lies in a ramp: an effect that this "
             "model lacks can look like it",
             change.time_s));
}

// Where the soak that is known worst is less certain than the drift is large, no compensation would
// do better.
void judge_uncertainty(Model& model, const NoiseWeightedFit& fit, const Eigen::MatrixXd& covariance,
                       const Rows& rows, std::vector<std::string>& warnings) {
  const SoakUncertainty worst = soak_uncertainty(model, fit, covariance, rows);
  const double drift_dph =
      std::sqrt(rows.drift_dph.cwiseAbs2().dot(rows.weights) / rows.weights.sum());
  model.uncertain.reset();
  if (worst.sigma_dph <= drift_dph) return;
  model.uncertain = Model::Uncertain{worst.sigma_dph, drift_dph};
  warnings.push_back(
      format("in a soak at %.4g degC the drift is known to +- %.2g deg/h, worse than "
             "the %.2g deg/h that are to be compensated: record more temperatures "
             "or rows, or leave effects out",
             worst.at_degc, worst.sigma_dph, drift_dph));
}

}  // namespace

bool searches_steps(const std::vector<EffectTerm>& terms) {
  return std::any_of(terms.begin(), terms.end(), is_sought);
}

Identification identify(Model& model, const SignalSeries& series,
                        const IdentifySettings& settings) {
  const Rows& rows = series.rows();
  std::optional<EffectTerm> step = take_out_step(model.terms);
  set_expression_ranges(model.terms, series);
  const Eigen::MatrixXd offsets = run_offset_columns(rows, settings.run_offsets);
  FitWithSteps found;
  if (step) {
    found = fit_with_steps(series, model.terms, offsets, settings.progress);
  } else {
    found.fit = fit_determined(series, model.terms, offsets, Eigen::VectorXd::Ones(rows.size()),
                               settings.progress);
  }
  const NoiseWeightedFit& fit = found.fit;
  model.terms = fit.terms;

  Identification result;
  result.residual_dph = fit.residual_dph;
  result.noise = fit.noise;
  result.misfit = fit.misfit();
  result.masked = found.masked;
  result.row_weights = fit.row_weights;
  result.outliers = fit.outliers;
  const Eigen::MatrixXd of_noise = std::pow(std::max(1.0, result.misfit), 2) * fit.covariance;
  const Eigen::MatrixXd all_covariance = coefficient_covariance(rows, fit);
  const Eigen::VectorXd sigma = all_covariance.diagonal().cwiseSqrt();
  const std::vector<ColumnRange> columns = columns_of(model.terms, rows.row_s);
  const Eigen::Index coefficients = columns.back().first + columns.back().count;
  const auto offset_values = fit.coefficients.segment(coefficients, offsets.cols());
  result.run_offsets_dph.assign(offset_values.begin(), offset_values.end());
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    EffectTerm& term = model.terms[i];
    const auto values = fit.coefficients.segment(columns[i].first, columns[i].count);
    const auto sigmas = sigma.segment(columns[i].first, columns[i].count);
    term.coefficients_dph.assign(values.begin(), values.end());
    if (values.cwiseAbs().maxCoeff() > kMaxModelDph) {
      throw InputError(term.name,
                       format("its coefficient would be %.2g deg/h: the effect is next to "
                              "nothing on these recordings; leave it out",
                              values.cwiseAbs().maxCoeff()));
    }
    term.sigma_dph.assign(sigmas.begin(), sigmas.end());
    const Eigen::MatrixXd part = fit.columns.middleCols(columns[i].first, columns[i].count);
    const Eigen::MatrixXd covariance = all_covariance.block(columns[i].first, columns[i].first,
                                                            columns[i].count, columns[i].count);
    const double largest_variance =
        (part * covariance).cwiseProduct(part).rowwise().sum().maxCoeff();
    result.visible_dph.push_back(kVisible * std::sqrt(largest_variance));
  }
  for (std::size_t i = 0; i < fit.shapes.size(); ++i) {
    EffectTerm& term = model.terms[fit.shapes[i].term];
    term.parameter_sigma[fit.shapes[i].index] =
        sigma[fit.linear() + static_cast<Eigen::Index>(i)] *
        fit.shapes[i].slope(term.parameters[fit.shapes[i].index]);
  }
  result.warnings = confusions(model.terms, columns, fit.covariance);
  for (std::size_t i = 0; i < found.steps.size(); ++i) {
    const Eigen::Index column = coefficients + offsets.cols() + static_cast<Eigen::Index>(i);
    step->coefficients_dph = {fit.coefficients[column]};
    step->sigma_dph = {sigma[column]};
    add_step(model, result, rows, found.steps[i], *step);
  }
  set_ranges(model, rows);
  for (const EffectTerm& term : model.terms) {
    for (const ShapeDoubt& doubt : shape_doubts(term)) result.warnings.push_back(doubt.sentence);
  }
  judge_uncertainty(model, fit, of_noise, rows, result.warnings);
  for (EffectTerm& term : model.terms) set_expression_scale(term, series);
  const Eigen::VectorXd counted = counted_weights(rows, fit.row_weights);
  model.residual_rms_dph = std::sqrt(result.residual_dph.cwiseAbs2().dot(counted) / counted.sum());
  return result;
}

}  // namespace fogcomp
