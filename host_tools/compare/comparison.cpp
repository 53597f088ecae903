#include "compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/drift_model.hpp"
#include "model/input_value.hpp"
#include "noise/outlier_rows.hpp"
#include "series/block_walk.hpp"
#include "series/required_inputs.hpp"
#include "series/signal_series.hpp"

namespace fogcomp {
namespace {

std::vector<std::string> names_of_parts(const Model& model) {
  std::vector<std::string> names;
  for (const EffectTerm& term : model.terms) names.push_back(term.name);
  if (model.network.present()) names.emplace_back("network");
  return names;
}

double part_dph(const RealDriftModel& drift, std::size_t part, std::size_t effects) {
  return part < effects ? drift.effect_dph(part) : drift.network_dph();
}

void add_weighted(double weight, const RealBlock& means, RealBlock& sum) {
  sum.input_rate += weight * means.input_rate;
  for (std::size_t i = 0; i < fog::kExtensionInputs; ++i) {
    sum.extension[i] += weight * means.extension[i];
  }
}

void scale(RealBlock& means, double factor) {
  means.input_rate *= factor;
  for (double& value : means.extension) value *= factor;
}

struct ModelledRows {
  std::vector<Comparison::Row> rows;
  std::vector<RowRange> stretches;
  std::vector<std::vector<double>> parts_dph;  // [part][row]
};

ModelledRows make_rows(const Model& model, const RunInBlocks& run, std::size_t parts) {
  const BlockSeries& series = run.blocks;
  require_inputs(model, series);
  const std::int64_t per_row = blocks_per_row(run.average_s, series.block_s);
  RealDriftModel drift(model, series.block_s);
  ModelledRows result;
  result.parts_dph.resize(parts);
  const double sample_s = series.block_s / series.samples_per_block;
  const double row_s = row_length_s(run.average_s, series.block_s);
  std::int64_t row_number = -1;
  double samples = 0;
  const auto finish = [&] {
    if (result.rows.empty()) return;
    Comparison::Row& row = result.rows.back();
    row.weight = samples * sample_s / row_s;
    row.time_s /= samples;
    row.temperature_degc /= samples;
    row.temperature_rate_degc_per_min /= samples;
    row.measured_dph /= samples;
    row.drift_dph /= samples;
    scale(row.inputs, 1 / samples);
    for (std::vector<double>& part : result.parts_dph) part.back() /= samples;
  };
  const auto begin_row = [&](std::int64_t number) {
    finish();
    if (result.rows.empty() || number != row_number + 1) {
      result.stretches.push_back({result.rows.size(), result.rows.size()});
    }
    ++result.stretches.back().end;
    result.rows.push_back({});
    for (std::vector<double>& part : result.parts_dph) part.push_back(0);
    row_number = number;
    samples = 0;
  };
  walk_blocks(series, drift, [&](const BlockSeries::Block& block) {
    if (result.rows.empty() || block.number / per_row != row_number) {
      begin_row(block.number / per_row);
    }
    const double weight = block.samples;
    Comparison::Row& row = result.rows.back();
    samples += weight;
    row.time_s += weight * block.time_s;
    row.temperature_degc += weight * block.means.temperature;
    row.temperature_rate_degc_per_min += weight * drift.signals().temperature_rate;
    row.measured_dph += weight * (block.rate_dph - block.means.input_rate);
    row.drift_dph += weight * drift.drift_dph();
    add_weighted(weight, block.means, row.inputs);
    for (std::size_t i = 0; i < parts; ++i) {
      result.parts_dph[i].back() += weight * part_dph(drift, i, model.terms.size());
    }
  });
  finish();
  return result;
}

std::vector<Comparison::VaryingInput> varying(const std::vector<Comparison::Row>& rows) {
  std::vector<Comparison::VaryingInput> found;
  for (const fog::Input input : kOptionalInputs) {
    Comparison::VaryingInput one{input, {}};
    for (const Comparison::Row& row : rows) one.values.push_back(optional_input(input, row.inputs));
    if (varies(one.values)) found.push_back(std::move(one));
  }
  return found;
}

// Rows count with the time behind them, outliers not at all.
Comparison::Segment summarise(const std::string& name, SegmentKind kind,
                              const std::vector<Comparison::Row>& rows, RowRange range) {
  Comparison::Segment segment;
  segment.name = name;
  segment.kind = kind;
  segment.range = range;
  double time = 0;
  double raw = 0;
  double residual = 0;
  for (std::size_t i = range.first; i < range.end; ++i) {
    if (rows[i].outlier) continue;
    time += rows[i].weight;
    raw += rows[i].weight * rows[i].measured_dph;
    residual += rows[i].weight * rows[i].residual_dph();
  }
  if (time == 0) return segment;
  segment.raw_mean_dph = raw / time;
  segment.mean_dph = residual / time;
  double raw_square = 0;
  double square = 0;
  for (std::size_t i = range.first; i < range.end; ++i) {
    if (rows[i].outlier) continue;
    raw_square += rows[i].weight * std::pow(rows[i].measured_dph - segment.raw_mean_dph, 2);
    square += rows[i].weight * std::pow(rows[i].residual_dph() - segment.mean_dph, 2);
  }
  const double freedom = std::max(time - 1, 1.0);
  segment.raw_std_dph = std::sqrt(raw_square / freedom);
  segment.std_dph = std::sqrt(square / freedom);
  segment.raw_rms_dph = std::sqrt(raw_square / time + std::pow(segment.raw_mean_dph, 2));
  segment.rms_dph = std::sqrt(square / time + std::pow(segment.mean_dph, 2));
  return segment;
}

std::vector<Comparison::Segment> summarise_segments(const RunInBlocks& run,
                                                    const std::vector<Comparison::Row>& rows) {
  std::vector<Comparison::Segment> segments;
  std::size_t first = 0;
  for (const RunInBlocks::TimedSegment& segment : run.segments) {
    std::size_t end = first;
    while (end < rows.size() && rows[end].time_s < segment.end_s) ++end;
    segments.push_back(summarise(segment.name, segment.kind, rows, {first, end}));
    first = end;
  }
  return segments;
}

}  // namespace

bool varies(const std::vector<double>& values) {
  constexpr double kRounding = 1e-9;
  if (values.empty()) return false;
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return *max - *min > kRounding * std::max(std::fabs(*min), std::fabs(*max));
}

double constant_rms_dph(const Comparison& comparison, const Comparison::Segment& segment) {
  const double constant_dph = comparison.whole.raw_mean_dph - comparison.whole.mean_dph;
  const auto count = static_cast<double>(segment.range.size());
  const double variance = std::pow(segment.raw_std_dph, 2) * (count - 1) / count;
  return std::hypot(std::sqrt(variance), segment.raw_mean_dph - constant_dph);
}

double floor_removed(double std_dph, double floor_dph) {
  return std::sqrt(std::max(0.0, std_dph * std_dph - floor_dph * floor_dph));
}

std::vector<double> Comparison::residuals_dph() const {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.residual_dph());
  return values;
}

std::vector<double> Comparison::measured_dph() const {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.measured_dph);
  return values;
}

std::vector<double> Comparison::bridged(std::vector<double> values) const {
  std::vector<bool> outlier;
  for (const Row& row : rows) outlier.push_back(row.outlier);
  bridge_outliers(outlier, stretches, values);
  return values;
}

std::vector<double> Comparison::counted(const std::vector<double>& values) const {
  std::vector<double> counted;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].outlier) counted.push_back(values[i]);
  }
  return counted;
}

Rows Comparison::as_rows(const std::vector<double>& values) const {
  Rows all;
  const auto size = static_cast<Eigen::Index>(rows.size());
  all.drift_dph = Eigen::Map<const Eigen::VectorXd>(values.data(), size);
  all.weights.resize(size);
  all.row_s = row_s;
  all.run_starts = {0};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    all.weights[static_cast<Eigen::Index>(i)] = row.weight;
    all.time_s.push_back(row.time_s);
    all.signals.push_back({row.temperature_degc, row.temperature_rate_degc_per_min, row.inputs});
    all.inputs.push_back(row.inputs);
  }
  return all;
}

Comparison compare_with(const Model& model, const RunInBlocks& run) {
  const std::vector<std::string> parts = names_of_parts(model);
  ModelledRows modelled = make_rows(model, run, parts.size());
  Comparison comparison;
  comparison.file = run.file;
  comparison.row_s = row_length_s(run.average_s, run.blocks.block_s);
  comparison.noise_floor_dph = run.noise_floor_dph;
  comparison.rows = std::move(modelled.rows);
  comparison.stretches = std::move(modelled.stretches);
  const Eigen::VectorXd counts = counted_rows(comparison.as_rows(comparison.measured_dph()));
  for (std::size_t i = 0; i < comparison.rows.size(); ++i) {
    comparison.rows[i].outlier = counts[static_cast<Eigen::Index>(i)] == 0;
    if (comparison.rows[i].outlier) ++comparison.outliers;
  }
  comparison.segments = summarise_segments(run, comparison.rows);
  comparison.whole =
      summarise("all", SegmentKind::soak, comparison.rows, {0, comparison.rows.size()});
  const std::vector<double> residual = comparison.counted(comparison.residuals_dph());
  const std::vector<double> measured = comparison.counted(comparison.measured_dph());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    comparison.effects.push_back(
        share_of(parts[i], comparison.counted(modelled.parts_dph[i]), residual, measured));
  }
  comparison.parts_dph = std::move(modelled.parts_dph);
  comparison.inputs = varying(comparison.rows);
  TrainedRange range(model, comparison.row_s);
  for (const Comparison::Row& row : comparison.rows) {
    range.count(row.time_s, row.temperature_degc, row.temperature_rate_degc_per_min);
  }
  comparison.outside = range.outside();
  return comparison;
}

}  // namespace fogcomp
