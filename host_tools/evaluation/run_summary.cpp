#include "evaluation/run_summary.hpp"

#include <algorithm>
#include <cmath>

#include "dataset/blocks.hpp"
#include "evaluation/noise_floor.hpp"
#include "support/units.hpp"

namespace fogcomp {
namespace {

struct Moments {
  double mean = 0;
  std::optional<double> deviation;
};

// About the first value, so that a small scatter on a large mean keeps its digits.
Moments moments(const std::vector<double>& values, RowRange rows) {
  if (rows.size() == 0) return {};
  const double origin = values[rows.first];
  double sum = 0;
  double squares = 0;
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const double value = values[row] - origin;
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(rows.size());
  Moments result{origin + sum / count, std::nullopt};
  if (rows.size() > 1) {
    result.deviation = std::sqrt(std::max(0.0, squares - sum * sum / count) / (count - 1));
  }
  return result;
}

BiasSummary summarize_bias(const std::vector<double>& bias, RowRange rows,
                           const std::vector<double>& block_bias, RowRange blocks) {
  const Moments samples = moments(bias, rows);
  return {samples.mean, moments(block_bias, blocks).deviation, samples.deviation};
}

SegmentSummary summarize_segment(const Recording& recording, const Segment& segment,
                                 const Segment& in_blocks) {
  SegmentSummary summary;
  summary.name = segment.name;
  summary.kind = segment.kind;
  summary.rows = segment.rows();
  summary.blocks = in_blocks.rows();
  const std::size_t last = segment.end_row - 1;
  summary.start_s = recording.time_s[segment.first_row];
  summary.end_s = recording.time_s[last];
  summary.duration_s = summary.end_s - summary.start_s + recording.period_s;
  const auto first = recording.temperature_degc.begin();
  const auto [least, most] =
      std::minmax_element(first + static_cast<std::ptrdiff_t>(segment.first_row),
                          first + static_cast<std::ptrdiff_t>(segment.end_row));
  summary.temperature_min_degc = *least;
  summary.temperature_max_degc = *most;
  if (last > segment.first_row) {
    summary.temperature_rate_degc_per_min =
        (recording.temperature_degc[last] - recording.temperature_degc[segment.first_row]) /
        (summary.end_s - summary.start_s) * kSecondsPerMinute;
  }
  return summary;
}

}  // namespace

RunSummary summarize(const Recording& recording, double average_s) {
  const std::vector<Segment> segments = find_segments(recording);
  Blocks blocks = block_means(recording, average_s);
  const std::vector<Segment> in_blocks = segments_in_blocks(segments, blocks);
  const std::vector<double> bias = bias_dph(recording);
  const std::vector<double> block_bias = bias_dph(blocks.means);

  RunSummary summary;
  summary.average_s = blocks.means.period_s;
  summary.bias = summarize_bias(bias, {0, recording.rows()}, block_bias, {0, blocks.means.rows()});
  summary.noise_floor_dph = noise_floor_dph(recording, summary.average_s);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SegmentSummary segment = summarize_segment(recording, segments[i], in_blocks[i]);
    segment.bias = summarize_bias(bias, {segments[i].first_row, segments[i].end_row}, block_bias,
                                  {in_blocks[i].first_row, in_blocks[i].end_row});
    summary.segments.push_back(std::move(segment));
  }
  const std::vector<RowRange> soaks = soak_ranges(recording, segments);
  for (const RowRange& soak : soaks) {
    summary.soak_s += static_cast<double>(soak.size()) * recording.period_s;
  }
  summary.allan = allan_deviation(bias, soaks, recording.period_s);
  summary.noise = fit_noise_coefficients(summary.allan);
  summary.sensitivity = temperature_sensitivity(blocks.means, in_blocks);
  summary.blocks = std::move(blocks.means);
  return summary;
}

}  // namespace fogcomp
