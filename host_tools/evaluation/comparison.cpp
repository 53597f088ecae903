#include "evaluation/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "dataset/segments.hpp"
#include "evaluation/noise_floor.hpp"
#include "identification/block_walk.hpp"
#include "identification/required_inputs.hpp"
#include "identification/signal_series.hpp"
#include "model/drift_model.hpp"

namespace fogcomp {
namespace {

std::vector<Comparison::Row> make_rows(const Model& model, const BlockSeries& series) {
  require_inputs(model, series);
  const std::int64_t per_row = blocks_per_row(model.average_s, series.block_s);
  RealDriftModel drift(model, series.block_s);
  std::vector<Comparison::Row> rows;
  std::int64_t row_number = -1;
  double samples = 0;
  const auto finish = [&] {
    if (rows.empty()) return;
    Comparison::Row& row = rows.back();
    row.time_s /= samples;
    row.temperature_degc /= samples;
    row.measured_dph /= samples;
    row.drift_dph /= samples;
  };
  walk_blocks(series, drift, [&](const BlockSeries::Block& block) {
    if (block.number / per_row != row_number) {
      finish();
      rows.push_back({});
      row_number = block.number / per_row;
      samples = 0;
    }
    const double weight = block.samples;
    Comparison::Row& row = rows.back();
    samples += weight;
    row.time_s += weight * block.time_s;
    row.temperature_degc += weight * block.means.temperature;
    row.measured_dph += weight * (block.rate_dph - block.means.input_rate);
    row.drift_dph += weight * drift.drift_dph();
  });
  finish();
  return rows;
}

Comparison::Segment summarise(const std::string& name, const Comparison::Row* first,
                              const Comparison::Row* end) {
  Comparison::Segment segment;
  segment.name = name;
  segment.rows = static_cast<std::size_t>(end - first);
  if (segment.rows == 0) return segment;
  const auto count = static_cast<double>(segment.rows);
  double raw = 0;
  double residual = 0;
  for (const Comparison::Row* row = first; row != end; ++row) {
    raw += row->measured_dph;
    residual += row->residual_dph();
  }
  segment.raw_mean_dph = raw / count;
  segment.mean_dph = residual / count;
  double raw_square = 0;
  double square = 0;
  for (const Comparison::Row* row = first; row != end; ++row) {
    raw_square += std::pow(row->measured_dph - segment.raw_mean_dph, 2);
    square += std::pow(row->residual_dph() - segment.mean_dph, 2);
  }
  const double freedom = std::max(count - 1, 1.0);
  segment.raw_std_dph = std::sqrt(raw_square / freedom);
  segment.std_dph = std::sqrt(square / freedom);
  segment.raw_rms_dph = std::sqrt(raw_square / count + std::pow(segment.raw_mean_dph, 2));
  segment.rms_dph = std::sqrt(square / count + std::pow(segment.mean_dph, 2));
  return segment;
}

}  // namespace

double floor_removed(double std_dph, double floor_dph) {
  return std::sqrt(std::max(0.0, std_dph * std_dph - floor_dph * floor_dph));
}

Comparison compare_with(const Model& model, const Recording& recording) {
  Comparison comparison;
  comparison.file = recording.file;
  comparison.rows = make_rows(model, make_blocks(recording));
  const Comparison::Row* const begin = comparison.rows.data();
  const Comparison::Row* const end = begin + comparison.rows.size();
  comparison.whole = summarise("all", begin, end);
  const Comparison::Row* first = begin;
  for (const Segment& segment : find_segments(recording)) {
    const double end_time_s =
        segment.end_row < recording.rows() ? recording.time_s[segment.end_row] : HUGE_VAL;
    const Comparison::Row* const last = std::find_if(
        first, end, [&](const Comparison::Row& row) { return row.time_s >= end_time_s; });
    comparison.segments.push_back(summarise(segment.name, first, last));
    first = last;
  }
  comparison.noise_floor_dph = noise_floor_dph(recording, model.average_s);
  const auto outside = std::count_if(begin, end, [&](const Comparison::Row& row) {
    return row.temperature_degc < model.least_degc || row.temperature_degc > model.most_degc;
  });
  comparison.outside_range = static_cast<double>(outside) /
                             static_cast<double>(std::max<std::size_t>(1, comparison.rows.size()));
  return comparison;
}

}  // namespace fogcomp
