#include "compare/run_summary.hpp"

#include <algorithm>
#include <cmath>

#include "noise/noise_floor.hpp"
#include "noise/outlier_rows.hpp"
#include "series/blocks.hpp"
#include "series/signal_series.hpp"
#include "support/units.hpp"

namespace fogcomp {
namespace {

struct Moments {
  double mean = 0;
  std::optional<double> deviation;
};

// Values of which some are outliers.
struct Judged {
  std::vector<double> values;
  std::vector<bool> outlier;
};

// Without the outliers; about the first value, so that a small scatter on a large mean keeps its
// digits.
Moments moments(const Judged& judged, RowRange rows) {
  double origin = 0;
  double count = 0;
  double sum = 0;
  double squares = 0;
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    if (judged.outlier[row]) continue;
    if (count == 0) origin = judged.values[row];
    const double value = judged.values[row] - origin;
    sum += value;
    squares += value * value;
    ++count;
  }
  if (count == 0) return {};
  Moments result{origin + sum / count, std::nullopt};
  if (count > 1) {
    result.deviation = std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1));
  }
  return result;
}

BiasSummary summarize_bias(const Judged& bias, RowRange rows, const Judged& block_bias,
                           RowRange blocks) {
  const Moments samples = moments(bias, rows);
  return {samples.mean, moments(block_bias, blocks).deviation, samples.deviation};
}

SegmentSummary summarize_segment(const Recording& recording, const Segment& segment,
                                 const Segment& in_blocks) {
  SegmentSummary summary;
  summary.name = segment.name;
  summary.kind = segment.kind;
  summary.rows = segment.rows.size();
  summary.blocks = in_blocks.rows.size();
  const std::size_t last = segment.rows.end - 1;
  summary.start_s = segment.start_s;
  summary.end_s = recording.time_s[last];
  summary.duration_s = summary.end_s - summary.start_s + recording.period_s;
  const auto first = recording.temperature_degc.begin();
  const auto [least, most] =
      std::minmax_element(first + static_cast<std::ptrdiff_t>(segment.rows.first),
                          first + static_cast<std::ptrdiff_t>(segment.rows.end));
  summary.temperature_min_degc = *least;
  summary.temperature_max_degc = *most;
  if (last > segment.rows.first) {
    summary.temperature_rate_degc_per_min =
        (recording.temperature_degc[last] - recording.temperature_degc[segment.rows.first]) /
        (summary.end_s - summary.start_s) * kSecondsPerMinute;
  }
  return summary;
}

// By the rows that fit and compare would make: whole blocks of theirs, where they are not longer.
double wanted_row_s(const Recording& recording, double average_s) {
  const double block_s = recording.period_s * samples_per_block(recording.period_s);
  return average_s > block_s && block_s > 0 ? row_length_s(average_s, block_s) : average_s;
}

Judged judge_blocks(const Recording& blocks) {
  ValuesInTime in_time{bias_dph(blocks), {}, stretches_of(blocks, {0, blocks.rows()}), {}};
  if (!blocks.input_rate_dph.empty()) in_time.inputs.push_back(blocks.input_rate_dph);
  for (const std::vector<double>& input : blocks.extension) {
    if (!input.empty()) in_time.inputs.push_back(input);
  }
  return {in_time.values, find_outliers(in_time)};
}

// All samples of a block that is an outlier are.
Judged judge_samples(const Recording& recording, const Blocks& blocks,
                     const std::vector<bool>& block_outlier) {
  Judged samples{bias_dph(recording), std::vector<bool>(recording.rows())};
  for (std::size_t block = 0; block < block_outlier.size(); ++block) {
    if (!block_outlier[block]) continue;
    const auto first =
        samples.outlier.begin() + static_cast<std::ptrdiff_t>(blocks.first_rows[block]);
    std::fill_n(first, blocks.rows_per_block, true);
  }
  return samples;
}

std::vector<double> bridged(const Judged& judged, const Recording& recording) {
  std::vector<double> values = judged.values;
  bridge_outliers(judged.outlier, stretches_of(recording, {0, recording.rows()}), values);
  return values;
}

// As a recording, for what looks at one.
Recording without_outliers(Recording blocks, const Judged& judged) {
  const std::vector<double> values = bridged(judged, blocks);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (judged.outlier[i]) blocks.rate_dph[i] += values[i] - judged.values[i];
  }
  return blocks;
}

}  // namespace

RunSummary summarize(const Recording& recording, double average_s) {
  const std::vector<Segment> segments = find_segments(recording);
  Blocks blocks = block_means(recording, wanted_row_s(recording, average_s));
  const std::vector<Segment> in_blocks =
      segments_on(segments, blocks.means.time_s, {0, blocks.means.rows()});
  const Judged block_bias = judge_blocks(blocks.means);
  const Judged bias = judge_samples(recording, blocks, block_bias.outlier);

  RunSummary summary;
  summary.average_s = blocks.means.period_s;
  summary.outliers = static_cast<std::size_t>(
      std::count(block_bias.outlier.begin(), block_bias.outlier.end(), true));
  summary.bias = summarize_bias(bias, {0, recording.rows()}, block_bias, {0, blocks.means.rows()});
  summary.noise_floor_dph = noise_floor_dph(recording, summary.average_s);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SegmentSummary segment = summarize_segment(recording, segments[i], in_blocks[i]);
    segment.bias = summarize_bias(bias, segments[i].rows, block_bias, in_blocks[i].rows);
    summary.segments.push_back(std::move(segment));
  }
  const std::vector<RowRange> soaks = soak_ranges(recording, segments);
  for (const RowRange& soak : soaks) {
    summary.soak_s += static_cast<double>(soak.size()) * recording.period_s;
  }
  summary.allan = allan_deviation(bridged(bias, recording), soaks, recording.period_s);
  summary.noise = fit_noise_coefficients(summary.allan);
  summary.sensitivity =
      temperature_sensitivity(without_outliers(blocks.means, block_bias), in_blocks);
  summary.blocks = std::move(blocks.means);
  return summary;
}

}  // namespace fogcomp
