#include "recording/recording.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/input_file.hpp"
#include "recording/reading.hpp"
#include "recording/row_range.hpp"
#include "recording/stream_reader.hpp"
#include "support/input_error.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

// Real UTF-16 has already been decoded.
void refuse_false_utf16(std::string_view head, const std::string& path) {
  if (head.substr(0, 2) != "\xFF\xFE" && head.substr(0, 2) != "\xFE\xFF") return;
  throw InputError(path,
                   "begins with a UTF-16 byte order mark, but is not UTF-16; save it as UTF-8");
}

void mask_unknown_flanks(Recording& recording, const ReadWatch& watch) {
  const UnknownFlanks unknown = unknown_flanks(recording);
  const std::string which =
      unknown.delay_s
          ? format("which it shows %.4g ms ", 1e3 * std::abs(*unknown.delay_s)) +
                (*unknown.delay_s > 0 ? "later" : "earlier") + " than the gyro"
          : "which the gyro sees otherwise (is it a commanded rate, or one value a sample?)";
  mask_unknown_input_rate(
      recording, unknown.masks, "at " + counted(unknown.masks.size(), "change") + ", " + which,
      unknown.delay_s ? "correct its clock"
                      : "record the mean over each sample of what the table does",
      watch);
}

std::vector<Recording::Label> labels_without(const Recording& recording,
                                             const std::vector<std::size_t>& removed) {
  std::vector<Recording::Label> labels;
  for (const Recording::Label& label : recording.labels) {
    const auto after = std::lower_bound(removed.begin(), removed.end(), label.first_row);
    const std::size_t first_row =
        label.first_row - static_cast<std::size_t>(after - removed.begin());
    if (!labels.empty() && labels.back().first_row == first_row) labels.pop_back();
    if (!labels.empty() && labels.back().text == label.text) continue;
    labels.push_back({first_row, label.text});
  }
  const std::size_t rows_left = recording.rows() - removed.size();
  if (!labels.empty() && labels.back().first_row == rows_left) labels.pop_back();
  return labels;
}

template <class Column>
void remove_from(Column& column, const std::vector<std::size_t>& removed) {
  if (column.empty()) return;
  std::size_t kept = removed.front();
  for (std::size_t i = 0; i < removed.size(); ++i) {
    const std::size_t end = i + 1 < removed.size() ? removed[i + 1] : column.size();
    for (std::size_t row = removed[i] + 1; row < end; ++row) column[kept++] = column[row];
  }
  column.resize(kept);
}

// Removes rounding errors of differences of printed times: 0.00499999999738 becomes 0.005.
double without_rounding_error(double period_s) {
  constexpr double kDigits = 9;
  const double units_per_s = std::pow(10, kDigits - std::floor(std::log10(period_s)));
  return std::round(period_s * units_per_s) / units_per_s;
}

}  // namespace

std::vector<double>& Recording::operator[](Column column) {
  constexpr std::vector<double> Recording::*kMembers[kFirstExtensionColumn] = {
      &Recording::time_s, &Recording::temperature_degc, &Recording::rate_dph,
      &Recording::input_rate_dph, &Recording::uptime_s};
  const auto number = static_cast<std::size_t>(column);
  return number < kFirstExtensionColumn ? this->*kMembers[number]
                                        : extension[number - kFirstExtensionColumn];
}

const std::vector<double>& Recording::operator[](Column column) const {
  return const_cast<Recording&>(*this)[column];
}

std::size_t Recording::restarts() const {
  std::size_t count = 0;
  for (std::size_t row = 1; row < rows(); ++row) {
    if (restarts_at(row)) ++count;
  }
  return count;
}

std::vector<double> bias_dph(const Recording& recording) {
  std::vector<double> bias = recording.rate_dph;
  for (std::size_t row = 0; row < recording.input_rate_dph.size(); ++row) {
    bias[row] -= recording.input_rate_dph[row];
  }
  return bias;
}

void remove_rows(Recording& recording, LineNumbers& lines, const std::vector<std::size_t>& rows) {
  if (rows.empty()) return;
  if (!lines.empty()) lines = lines.without(rows, recording.rows());
  recording.labels = labels_without(recording, rows);
  for (const ColumnInfo& info : kColumns) remove_from(recording[info.column], rows);
  remove_from(recording.temperature_is_read, rows);
}

bool RateResolution::varies() const {
  return range_dph >
         rules::kRoundings * std::numeric_limits<double>::epsilon() * std::max(size_dph, 1.0);
}

double RateResolution::rounding_dph() const {
  const double of_digits = step_dph / std::sqrt(12.0);
  return std::max(of_digits, rules::kRoundings * std::numeric_limits<double>::epsilon() * size_dph);
}

RateResolution rate_resolution(const Recording& recording) {
  RateResolution resolution;
  const std::vector<double>& rate = recording.rate_dph;
  if (rate.empty()) return resolution;
  const auto [min, max] = std::minmax_element(rate.begin(), rate.end());
  resolution.range_dph = *max - *min;
  resolution.size_dph = std::max(std::abs(*min), std::abs(*max));
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t row = 1; row < rate.size(); ++row) {
    const double change = std::abs(rate[row] - rate[row - 1]);
    if (change > 0 && change < step) step = change;
  }
  if (std::isfinite(step)) resolution.step_dph = step;
  return resolution;
}

void require_varying_rate(const Recording& recording) {
  if (recording.rows() < 2 || rate_resolution(recording).varies()) return;
  throw InputError(recording.file,
                   format("the rate does not move: %.10g deg/h in all %zu samples; is "
                          "the gyro on and connected?",
                          recording.rate_dph[0], recording.rows()));
}

double median_spacing_s(const std::vector<double>& time_s) {
  constexpr std::size_t kMaxSpacings = 65536;
  constexpr std::size_t kScatter = 7919;  // a prime: spacings may have a rhythm, of packets
  const std::size_t step = time_s.size() / kMaxSpacings + 1;
  std::vector<double> spacings;
  for (std::size_t i = 1; i + step <= time_s.size(); i += step) {
    const std::size_t row = i + i * kScatter % step;
    spacings.push_back(time_s[row] - time_s[row - 1]);
  }
  // Of a clock that jitters while samples are lost, most spacings are long.
  double period_s = median(spacings);
  constexpr int kPeriodRounds = 5;  // until the counts of samples stay
  for (int round = 0; round < kPeriodRounds && period_s > 0; ++round) {
    double samples = 0;
    double sum_s = 0;
    for (const double each_s : spacings) {
      if (each_s > rules::kMaxDropoutS) continue;
      samples += std::round(each_s / period_s);
      sum_s += each_s;
    }
    if (samples > 0) period_s = sum_s / samples;
  }
  return period_s;
}

void find_stretches(Recording& recording) {
  recording.stretch_starts = {0};
  recording.period_s = 0;
  const std::vector<double>& time_s = recording.time_s;
  if (time_s.size() < 2) return;
  const double typical_s = median_spacing_s(time_s);
  double spanned_s = 0;
  std::size_t spacings = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double spacing_s = time_s[i] - time_s[i - 1];
    if (is_gap(spacing_s, typical_s) || recording.restarts_at(i)) {
      recording.stretch_starts.push_back(i);
    } else {
      spanned_s += spacing_s;
      ++spacings;
    }
  }
  const double period_s = spanned_s / static_cast<double>(spacings);
  if (period_s < rules::kMinPeriodS || period_s > rules::kMaxPeriodS) {
    throw InputError(
        recording.file,
        format("samples are %g s apart; is the time in s? if not, give --columns time=NAME[us]",
               period_s));
  }
  recording.period_s = without_rounding_error(period_s);
}

void become_table(Recording& recording) {
  const double end_s = recording.time_s.back() + kDwellSpacingS;
  for (double& time_s : recording.time_s) time_s -= end_s;
  recording.is_table = true;
  recording.period_s = 0;
  recording.stretch_starts.resize(recording.rows());
  std::iota(recording.stretch_starts.begin(), recording.stretch_starts.end(), 0);
}

Recording read_recording(const std::string& path, const ReadOptions& options) {
  InputFile file(path, options.watch.progress);
  return read_recording(file, options);
}

Recording read_recording(InputFile& file, const ReadOptions& options) {
  const std::string& path = file.path();
  const std::string_view head = file.peek();
  if (head.empty()) throw InputError(path, "is empty; is it the right file?");
  refuse_foreign_format(head, path);

  Recording recording;
  LineNumbers lines;
  if (options.is_table && (find_output_frames(head) || is_sensor_stream(head))) {
    throw InputError(path, "is a stream of samples, no table; leave --table out");
  }
  if (const auto frames = find_output_frames(head)) {
    recording = read_output_stream(file, *frames, options);
  } else if (is_sensor_stream(head)) {
    recording = read_sensor_stream(file, options);
  } else {
    refuse_false_utf16(head, path);
    recording = read_csv(file, options, lines);
    if (!options.join.empty()) join_file(recording, lines, options);
  }
  if (recording.input_rate_dph.empty() && options.default_input_rate_dph != 0) {
    recording.input_rate_dph.assign(recording.rows(), options.default_input_rate_dph);
  }
  const std::vector<Mask> given = masks_of(options.masks, path);
  recording.masks.insert(recording.masks.end(), given.begin(), given.end());
  if (!options.keep_refused_rows && recording.rows_per_row == 1 && !options.is_table) {
    leave_out_sentinels(recording, lines, options.watch);
  }
  find_stretches(recording);
  mask_unknown_flanks(recording, options.watch);
  if (!options.keep_refused_rows && recording.rows_per_row == 1) {
    leave_out_refused_rows(recording, lines, options.limits.over(options.model_limits),
                           options.watch);
    if (recording.refused_rows > 0) find_stretches(recording);
  }
  if (options.is_table) become_table(recording);
  return recording;
}

}  // namespace fogcomp::recording
