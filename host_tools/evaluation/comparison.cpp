#include "evaluation/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "identification/block_walk.hpp"
#include "identification/required_inputs.hpp"
#include "identification/signal_series.hpp"
#include "model/drift_model.hpp"

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

// Column i of `inputs` below: the extension inputs in their order, then the input rate.
constexpr std::size_t kInputColumnCount = fog::kExtensionInputs + 1;
static_assert(static_cast<std::size_t>(fog::Input::input_rate) == fog::kExtensionInputs);

double input_of(const fog::BlockMeans<RealNumbers>& means, std::size_t column) {
  return column < fog::kExtensionInputs ? means.extension[column] : means.input_rate;
}

struct ModelledRows {
  std::vector<Comparison::Row> rows;
  std::vector<RowRange> stretches;
  std::vector<std::vector<double>> parts_dph;  // [part][row]
  std::array<std::vector<double>, kInputColumnCount> inputs;
};

ModelledRows make_rows(const Model& model, const RunInBlocks& run, std::size_t parts) {
  const BlockSeries& series = run.blocks;
  require_inputs(model, series);
  const std::int64_t per_row = blocks_per_row(run.average_s, series.block_s);
  RealDriftModel drift(model, series.block_s);
  ModelledRows result;
  result.parts_dph.resize(parts);
  std::int64_t row_number = -1;
  double samples = 0;
  const auto finish = [&] {
    if (result.rows.empty()) return;
    Comparison::Row& row = result.rows.back();
    row.time_s /= samples;
    row.temperature_degc /= samples;
    row.temperature_rate_degc_per_min /= samples;
    row.measured_dph /= samples;
    row.drift_dph /= samples;
    for (std::vector<double>& part : result.parts_dph) part.back() /= samples;
    for (std::vector<double>& input : result.inputs) input.back() /= samples;
  };
  const auto begin_row = [&](std::int64_t number) {
    finish();
    if (result.rows.empty() || number != row_number + 1) {
      result.stretches.push_back({result.rows.size(), result.rows.size()});
    }
    ++result.stretches.back().end;
    result.rows.push_back({});
    for (std::vector<double>& part : result.parts_dph) part.push_back(0);
    for (std::vector<double>& input : result.inputs) input.push_back(0);
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
    for (std::size_t i = 0; i < parts; ++i) {
      result.parts_dph[i].back() += weight * part_dph(drift, i, model.terms.size());
    }
    for (std::size_t i = 0; i < kInputColumnCount; ++i) {
      result.inputs[i].back() += weight * input_of(block.means, i);
    }
  });
  finish();
  return result;
}

std::vector<Comparison::VaryingInput> varying(
    std::array<std::vector<double>, kInputColumnCount> inputs) {
  std::vector<Comparison::VaryingInput> found;
  for (std::size_t i = 0; i < kInputColumnCount; ++i) {
    if (varies(inputs[i])) found.push_back({static_cast<fog::Input>(i), std::move(inputs[i])});
  }
  return found;
}

Comparison::Segment summarise(const std::string& name, SegmentKind kind,
                              const std::vector<Comparison::Row>& rows, RowRange range) {
  Comparison::Segment segment;
  segment.name = name;
  segment.kind = kind;
  segment.range = range;
  if (range.size() == 0) return segment;
  const auto count = static_cast<double>(range.size());
  double raw = 0;
  double residual = 0;
  for (std::size_t i = range.first; i < range.end; ++i) {
    raw += rows[i].measured_dph;
    residual += rows[i].residual_dph();
  }
  segment.raw_mean_dph = raw / count;
  segment.mean_dph = residual / count;
  double raw_square = 0;
  double square = 0;
  for (std::size_t i = range.first; i < range.end; ++i) {
    raw_square += std::pow(rows[i].measured_dph - segment.raw_mean_dph, 2);
    square += std::pow(rows[i].residual_dph() - segment.mean_dph, 2);
  }
  const double freedom = std::max(count - 1, 1.0);
  segment.raw_std_dph = std::sqrt(raw_square / freedom);
  segment.std_dph = std::sqrt(square / freedom);
  segment.raw_rms_dph = std::sqrt(raw_square / count + std::pow(segment.raw_mean_dph, 2));
  segment.rms_dph = std::sqrt(square / count + std::pow(segment.mean_dph, 2));
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

Comparison compare_with(const Model& model, const RunInBlocks& run) {
  const std::vector<std::string> parts = names_of_parts(model);
  ModelledRows modelled = make_rows(model, run, parts.size());
  Comparison comparison;
  comparison.file = run.file;
  comparison.row_s =
      static_cast<double>(blocks_per_row(run.average_s, run.blocks.block_s)) * run.blocks.block_s;
  comparison.noise_floor_dph = run.noise_floor_dph;
  comparison.rows = std::move(modelled.rows);
  comparison.stretches = std::move(modelled.stretches);
  comparison.segments = summarise_segments(run, comparison.rows);
  comparison.whole =
      summarise("all", SegmentKind::soak, comparison.rows, {0, comparison.rows.size()});
  const std::vector<double> residual = comparison.residuals_dph();
  const std::vector<double> measured = comparison.measured_dph();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    comparison.effects.push_back(share_of(parts[i], modelled.parts_dph[i], residual, measured));
  }
  comparison.parts_dph = std::move(modelled.parts_dph);
  comparison.inputs = varying(std::move(modelled.inputs));
  TrainedRange range(model, comparison.row_s);
  for (const Comparison::Row& row : comparison.rows) {
    range.count(row.time_s, row.temperature_degc, row.temperature_rate_degc_per_min);
  }
  comparison.outside = range.outside();
  return comparison;
}

}  // namespace fogcomp
