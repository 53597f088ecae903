#include "compare/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "compare/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "model/drift_model.hpp"
#include "model/input_value.hpp"
#include "noise/decision_rules.hpp"
#include "noise/outlier_rows.hpp"
#include "series/block_walk.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::compare {
namespace {

std::vector<std::string> names_of_parts(const model::Model& model) {
  std::vector<std::string> names;
  for (const model::EffectTerm& term : model.terms) names.push_back(term.name);
  if (model.network.present()) names.emplace_back("network");
  return names;
}

struct ModelledRows {
  series::Rows rows;
  Eigen::VectorXd drift_dph;
  std::vector<std::vector<double>> parts_dph;  // [part][row]
};

ModelledRows modelled_rows(const model::Model& model, const runs::Run& run, double row_s,
                           std::size_t parts) {
  series::require_inputs(model, run.blocks);
  const model::Model acting = model::as_it_acts_on(model, run.blocks.recordings);
  model::RealDriftModel drift(acting, run.blocks.block_s);
  ModelledRows result;
  series::RowAverager averager(run.blocks, row_s, result.rows, 1 + parts);
  std::vector<double> values(1 + parts);
  series::run_blocks(run.blocks, drift, [&](const series::BlockSeries::Block& block) {
    values[0] = drift.drift_dph();
    for (std::size_t i = 0; i < parts; ++i) {
      values[1 + i] = i < model.terms.size() ? drift.effect_dph(i) : drift.network_dph();
    }
    averager.take(block, drift.signals(), values.data());
  });
  averager.finish();
  result.drift_dph = averager.further().col(0);
  for (std::size_t i = 0; i < parts; ++i) {
    const auto part = averager.further().col(static_cast<Eigen::Index>(1 + i));
    result.parts_dph.emplace_back(part.begin(), part.end());
  }
  return result;
}

std::vector<Comparison::VaryingInput> varying(const series::Rows& rows) {
  std::vector<Comparison::VaryingInput> found;
  for (const fog::Input input : model::kOptionalInputs) {
    Comparison::VaryingInput one{input, {}};
    for (const model::RealBlock& means : rows.inputs)
      one.values.push_back(model::optional_input(input, means));
    if (varies(one.values)) found.push_back(std::move(one));
  }
  return found;
}

struct WeightedMoments {
  double mean = 0;
  double deviation = 0;  // with n - 1 in the denominator
  double rms = 0;
};

WeightedMoments weighted_moments(const Eigen::VectorXd& values, const Eigen::VectorXd& weights) {
  const double time = weights.sum();
  if (time == 0) return {};
  const double mean = values.dot(weights) / time;
  const double square = ((values.array() - mean).square() * weights.array()).sum();
  return {mean, std::sqrt(square / std::max(time - 1, 1.0)),
          std::sqrt(square / time + mean * mean)};
}

Comparison::SegmentError error_in(const Comparison& comparison, const recording::Segment& segment) {
  const auto part = [&](const Eigen::VectorXd& values) -> Eigen::VectorXd {
    return series::of_rows(values, segment.rows);
  };
  Eigen::VectorXd weights = part(comparison.rows.weights);
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    if (comparison.outlier[segment.rows.first + static_cast<std::size_t>(i)]) weights[i] = 0;
  }
  const Eigen::VectorXd measured = part(comparison.rows.drift_dph);
  const WeightedMoments raw = weighted_moments(measured, weights);
  const WeightedMoments residual =
      weighted_moments(measured - part(comparison.modelled_dph), weights);
  Comparison::SegmentError error;
  static_cast<recording::Segment&>(error) = segment;
  error.raw_mean_dph = raw.mean;
  error.raw_std_dph = raw.deviation;
  error.raw_rms_dph = raw.rms;
  error.mean_dph = residual.mean;
  error.std_dph = residual.deviation;
  error.rms_dph = residual.rms;
  return error;
}

// Each part of a cut run has a bias of its own, which is no error of the model.
void take_own_biases(const Eigen::VectorXd& counts, Comparison& comparison) {
  series::Rows& rows = comparison.rows;
  const Eigen::VectorXd weights = rows.weights.cwiseProduct(counts);
  comparison.modelled_dph =
      rows.drift_dph - rows.about_biases(rows.drift_dph - comparison.modelled_dph, weights);
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    if (rows.weights[row] == 0) comparison.outlier[static_cast<std::size_t>(row)] = true;
  }
}

OutsideTraining outside_training(const model::Model& model, const series::Rows& rows) {
  TrainedRange range(model, rows.row_s);
  const std::vector<double> rates = rows.temperature_rates_degc_per_min();
  for (std::size_t i = 0; i < rates.size(); ++i) {
    range.count(rows.time_s[i], rows.inputs[i], rates[i]);
  }
  return range.outside();
}

struct Spread {
  double mean = 0;
  double squares = 0;  // sum, about the mean
};

template <class Value>
Spread spread_of(std::size_t count, Value value_at) {
  Spread spread;
  for (std::size_t i = 0; i < count; ++i) spread.mean += value_at(i);
  spread.mean /= static_cast<double>(std::max<std::size_t>(1, count));
  for (std::size_t i = 0; i < count; ++i) spread.squares += std::pow(value_at(i) - spread.mean, 2);
  return spread;
}

constexpr model::Range kEverything{-HUGE_VAL, HUGE_VAL};

model::Range widened(const std::optional<model::Range>& trained, double min_margin) {
  if (!trained) return kEverything;
  const double margin = std::max(min_margin, rules::kRateMargin * (trained->max - trained->min));
  return {trained->min - margin, trained->max + margin};
}

model::Range time_limits(const model::Model& model, double row_s) {
  if (!model.time_range_s) return kEverything;
  const bool needs_time = (model::needs_of(model) & bit_of(fog::Input::elapsed)) != 0;
  return {model.time_range_s->min - row_s, needs_time ? model.time_range_s->max + row_s : HUGE_VAL};
}

std::array<model::Range, fog::kExtensionInputs> input_limits(const model::Model& model) {
  std::array<model::Range, fog::kExtensionInputs> limits;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const bool needed = has(model::needs_of(model), fog::extension_input(i));
    const auto& trained = model.input_ranges[i];
    limits[i] = needed && trained ? trained->range : kEverything;
  }
  return limits;
}

}  // namespace

EffectShare share_of(const std::string& name, const std::vector<double>& part_dph,
                     const std::vector<double>& residual_dph,
                     const std::vector<double>& measured_dph) {
  const std::size_t count = part_dph.size();
  const Spread part = spread_of(count, [&](std::size_t i) { return part_dph[i]; });
  const Spread with = spread_of(count, [&](std::size_t i) { return residual_dph[i]; });
  const Spread without =
      spread_of(count, [&](std::size_t i) { return residual_dph[i] + part_dph[i]; });
  const Spread raw = spread_of(count, [&](std::size_t i) { return measured_dph[i]; });
  const double degrees_of_freedom = std::max(1.0, static_cast<double>(count) - 1);
  return {name, part.mean, std::sqrt(part.squares / degrees_of_freedom),
          raw.squares > 0 ? (without.squares - with.squares) / raw.squares : 0};
}

bool varies(const std::vector<double>& values) {
  if (values.empty()) return false;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return *max - *min > rules::kStandsStill * std::max(std::fabs(*min), std::fabs(*max));
}

double constant_rms_dph(const Comparison& comparison, const Comparison::SegmentError& segment) {
  const double constant_dph = comparison.whole.raw_mean_dph - comparison.whole.mean_dph;
  const auto count = static_cast<double>(segment.rows.size());
  const double variance = std::pow(segment.raw_std_dph, 2) * (count - 1) / count;
  return std::hypot(std::sqrt(variance), segment.raw_mean_dph - constant_dph);
}

double floor_removed(double std_dph, double floor_dph) {
  return std::sqrt(std::max(0.0, std_dph * std_dph - floor_dph * floor_dph));
}

std::optional<double> floor_removed(double std_dph, const std::optional<double>& floor_dph) {
  if (!floor_dph) return std::nullopt;
  return floor_removed(std_dph, *floor_dph);
}

const Comparison::SegmentError* Comparison::worst_segment() const {
  const auto worst =
      std::max_element(segments.begin(), segments.end(),
                       [](const auto& a, const auto& b) { return a.rms_dph < b.rms_dph; });
  return segments.size() < 2 || worst->rows.size() == 0 ? nullptr : &*worst;
}

std::vector<double> Comparison::residuals_dph() const {
  const Eigen::VectorXd residual = rows.drift_dph - modelled_dph;
  return {residual.begin(), residual.end()};
}

std::vector<double> Comparison::measured_dph() const {
  return {rows.drift_dph.begin(), rows.drift_dph.end()};
}

std::vector<double> Comparison::residuals_about_bias_dph() const {
  Eigen::VectorXd weights = rows.weights;
  for (std::size_t row = 0; row < size(); ++row) {
    if (outlier[row]) weights[static_cast<Eigen::Index>(row)] = 0;
  }
  const Eigen::VectorXd residual = rows.about_biases(rows.drift_dph - modelled_dph, weights);
  return {residual.begin(), residual.end()};
}

std::vector<double> Comparison::bridged(std::vector<double> values) const {
  noise::bridge_outliers(outlier, rows.stretches(), values);
  return values;
}

std::vector<double> Comparison::counted(const std::vector<double>& values) const {
  std::vector<double> counted;
  for (std::size_t i = 0; i < outlier.size(); ++i) {
    if (!outlier[i]) counted.push_back(values[i]);
  }
  return counted;
}

Comparison compare_with(const model::Model& model, const runs::Run& run, double row_s) {
  const std::vector<std::string> parts = names_of_parts(model);
  ModelledRows modelled = modelled_rows(model, run, row_s, parts.size());
  Comparison comparison;
  comparison.file = run.file;
  comparison.files = run.files;
  comparison.noise_floor_dph = run.noise_floor_dph(row_s);
  comparison.rows = std::move(modelled.rows);
  comparison.modelled_dph = std::move(modelled.drift_dph);
  const Eigen::VectorXd counts = noise::counted_rows(comparison.rows);
  for (const double count : counts) comparison.outlier.push_back(count == 0);
  if (!comparison.rows.cut_rows.empty()) take_own_biases(counts, comparison);
  comparison.outliers = static_cast<std::size_t>((counts.array() == 0).count());
  const recording::RowRange all{0, comparison.size()};
  for (const recording::Segment& segment :
       recording::segments_on(run.segments, comparison.rows.time_s, all)) {
    comparison.segments.push_back(error_in(comparison, segment));
  }
  comparison.whole = error_in(comparison, {"all", recording::SegmentKind::soak, 0, 0, all});
  const std::vector<double> residual = comparison.counted(comparison.residuals_dph());
  const std::vector<double> measured = comparison.counted(comparison.measured_dph());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    comparison.effects.push_back(
        share_of(parts[i], comparison.counted(modelled.parts_dph[i]), residual, measured));
  }
  comparison.parts_dph = std::move(modelled.parts_dph);
  comparison.inputs = varying(comparison.rows);
  comparison.outside = outside_training(model, comparison.rows);
  return comparison;
}

TrainedRange::TrainedRange(const model::Model& model, double row_s)
    : degc_{model.min_degc, model.max_degc},
      rate_(widened(model.rate_range_degc_per_min, noise::rules::kMaxQuietRate)),
      time_(time_limits(model, row_s)),
      input_rate_(widened(model.input_rate_range_dph, 0)),
      inputs_(input_limits(model)) {}

void TrainedRange::count(double time_s, const fog::BlockMeans<model::RealNumbers>& inputs,
                         double rate_degc_per_min) {
  ++rows_;
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    if (!inputs_[i].holds(inputs.extension[i])) ++rows_outside_.inputs[i];
  }
  if (!degc_.holds(inputs.temperature)) ++rows_outside_.temperature;
  if (!rate_.holds(rate_degc_per_min)) ++rows_outside_.temperature_rate;
  if (!input_rate_.holds(inputs.input_rate)) ++rows_outside_.input_rate;
  if (time_s < time_.min) ++rows_outside_.sooner;
  if (time_s > time_.max) ++rows_outside_.later;
}

OutsideTraining TrainedRange::outside() const {
  const double rows = std::max(1.0, rows_);
  OutsideTraining outside{rows_outside_.temperature / rows, rows_outside_.temperature_rate / rows,
                          rows_outside_.sooner / rows, rows_outside_.later / rows,
                          rows_outside_.input_rate / rows};
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    outside.inputs[i] = rows_outside_.inputs[i] / rows;
  }
  return outside;
}

}  // namespace fogcomp::compare
