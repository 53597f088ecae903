#include "compare/run_summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/comparison.hpp"
#include "noise/input_rate.hpp"
#include "noise/noise_floor.hpp"
#include "noise/outlier_rows.hpp"
#include "recording/mask.hpp"
#include "series/complete_rows.hpp"
#include "series/signal_series.hpp"
#include "support/units.hpp"

namespace fogcomp::compare {
namespace {

struct Moments {
  double mean = 0;
  std::optional<double> deviation;
};

// Values with some outliers.
struct Judged {
  std::vector<double> values;
  std::vector<bool> outlier;
};

// Without outliers; relative to the first value, so that a small scatter about a large mean keeps
// its digits.
Moments moments(const Judged& judged, recording::RowRange rows) {
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

BiasSummary summarize_bias(const Judged& bias, recording::RowRange samples, const Judged& row_bias,
                           recording::RowRange rows) {
  const Moments all = moments(bias, samples);
  return {all.mean, moments(row_bias, rows).deviation, all.deviation};
}

SegmentSummary summarize_segment(const recording::Recording& recording,
                                 const recording::Segment& segment) {
  SegmentSummary summary;
  summary.name = segment.name;
  summary.kind = segment.kind;
  summary.rows = segment.rows.size();
  const std::size_t last = segment.rows.end - 1;
  summary.start_s = segment.start_s;
  summary.end_s = recording.time_s[last];
  summary.duration_s = summary.end_s - summary.start_s + recording.period_s;
  const auto first = recording.temperature_degc.begin();
  const auto [min, max] =
      std::minmax_element(first + static_cast<std::ptrdiff_t>(segment.rows.first),
                          first + static_cast<std::ptrdiff_t>(segment.rows.end));
  summary.temperature_min_degc = *min;
  summary.temperature_max_degc = *max;
  if (last > segment.rows.first) {
    summary.temperature_rate_degc_per_min =
        (recording.temperature_degc[last] - recording.temperature_degc[segment.rows.first]) /
        (summary.end_s - summary.start_s) * kSecondsPerMinute;
  }
  return summary;
}

// Row length as in fit and compare: whole blocks, if these are not longer.
double wanted_row_s(const recording::Recording& recording, double average_s) {
  const double block_s = recording.period_s * series::samples_per_block(recording.period_s);
  return average_s > block_s && block_s > 0 ? series::row_length_s(average_s, block_s) : average_s;
}

Judged judge_rows(const recording::Recording& rows) {
  noise::ValuesInTime in_time{
      recording::bias_dph(rows), {}, recording::stretches_of(rows, {0, rows.rows()}), {}};
  if (!rows.input_rate_dph.empty()) in_time.inputs.push_back(rows.input_rate_dph);
  for (const std::vector<double>& input : rows.extension) {
    if (!input.empty()) in_time.inputs.push_back(input);
  }
  return {in_time.values, noise::find_outliers(in_time)};
}

// All samples of an outlier row are outliers.
Judged judge_samples(const recording::Recording& recording, const series::CompleteRows& rows,
                     const std::vector<bool>& row_outlier) {
  Judged samples{recording::bias_dph(recording), std::vector<bool>(recording.rows())};
  for (std::size_t row = 0; row < row_outlier.size(); ++row) {
    if (!row_outlier[row]) continue;
    const auto first =
        samples.outlier.begin() + static_cast<std::ptrdiff_t>(rows.first_samples[row]);
    std::fill_n(first, rows.samples_per_row, true);
  }
  return samples;
}

std::vector<double> bridged(Judged judged, const recording::Recording& recording) {
  noise::bridge_outliers(judged.outlier, recording::stretches_of(recording, {0, recording.rows()}),
                         judged.values);
  return std::move(judged.values);
}

// As a recording, for functions that need one.
recording::Recording without_outliers(recording::Recording rows, const Judged& judged) {
  const std::vector<double> values = bridged(judged, rows);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (judged.outlier[i]) rows.rate_dph[i] += values[i] - judged.values[i];
  }
  return rows;
}

std::optional<double> input_rate_share(const recording::Recording& rows) {
  if (!varies(rows.input_rate_dph)) return std::nullopt;
  const auto vector = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  };
  const std::vector<double> bias = recording::bias_dph(rows);
  return noise::share_of_input_rate(
      noise::input_rate_columns(vector(rows.input_rate_dph), vector(rows.temperature_degc), 1),
      vector(bias));
}

// `recording`: `masked` with its masked times bridged, which do not have the noise.
RunSummary summary_of(const recording::Recording& recording, const recording::Recording& masked,
                      double average_s) {
  const std::vector<recording::Segment> segments = recording::find_segments(recording);
  series::CompleteRows rows = series::complete_rows(recording, wanted_row_s(recording, average_s));
  const std::vector<recording::Segment> in_rows =
      recording::segments_on(segments, rows.means.time_s, {0, rows.means.rows()});
  const Judged row_bias = judge_rows(rows.means);
  Judged bias = judge_samples(recording, rows, row_bias.outlier);

  RunSummary summary;
  summary.average_s = rows.means.period_s;
  summary.outliers =
      static_cast<std::size_t>(std::count(row_bias.outlier.begin(), row_bias.outlier.end(), true));
  summary.bias = summarize_bias(bias, {0, recording.rows()}, row_bias, {0, rows.means.rows()});
  summary.noise_floor_dph = noise::noise_floor_dph(masked, summary.average_s);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    SegmentSummary segment = summarize_segment(recording, segments[i]);
    segment.bias = summarize_bias(bias, segments[i].rows, row_bias, in_rows[i].rows);
    summary.segments.push_back(std::move(segment));
  }
  const std::vector<recording::RowRange> soaks = noise::soak_ranges(recording, segments);
  for (const recording::RowRange& soak : soaks) {
    summary.soak_s += static_cast<double>(soak.size()) * recording.period_s;
  }
  summary.allan =
      noise::allan_deviation(bridged(std::move(bias), recording), soaks, recording.period_s);
  summary.noise = noise::fit_noise_coefficients(summary.allan);
  summary.sensitivity = temperature_sensitivity(without_outliers(rows.means, row_bias), in_rows);
  summary.input_rate_share = input_rate_share(rows.means);
  summary.blocks = std::move(rows.means);
  return summary;
}

}  // namespace

std::optional<double> RunSummary::drift_dph(const BiasSummary& of) const {
  return of.std_dph && noise_floor_dph ? floor_removed(*of.std_dph, noise_floor_dph) : std::nullopt;
}

RunSummary summarize(const recording::Recording& recording, double average_s) {
  if (recording.masks.empty()) return summary_of(recording, recording, average_s);
  recording::Recording bridged = without_outliers(
      recording,
      {recording::bias_dph(recording), recording::covered(recording.masks, recording.time_s)});
  bridged.masks.clear();
  return summary_of(bridged, recording, average_s);
}

}  // namespace fogcomp::compare
