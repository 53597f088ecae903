#include "recording/recording.hpp"

#include <cmath>

#include "recording/input_file.hpp"
#include "recording/reading.hpp"
#include "recording/stream_reader.hpp"
#include "support/input_error.hpp"
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
  const std::string changes = "at " + counted(unknown.masks.size(), "change");
  if (unknown.delay_s) {
    const double delay_s = *unknown.delay_s;
    mask_unknown_input_rate(recording, unknown.masks,
                            changes + format(", which it shows %.4g ms ", 1e3 * std::abs(delay_s)) +
                                (delay_s > 0 ? "later" : "earlier") + " than the gyro",
                            "correct its clock", watch);
  } else {
    mask_unknown_input_rate(recording, unknown.masks,
                            changes +
                                ", which the gyro sees otherwise (is it a commanded rate, or one "
                                "value a sample?)",
                            "record the mean over each sample of what the table does", watch);
  }
}

}  // namespace

std::vector<double>& Recording::operator[](Column column) {
  switch (column) {
    case Column::time_s:
      return time_s;
    case Column::temperature_degc:
      return temperature_degc;
    case Column::rate_dph:
      return rate_dph;
    case Column::input_rate_dph:
      return input_rate_dph;
    case Column::uptime_s:
      return uptime_s;
  }
  return extension[static_cast<std::size_t>(column) - kFirstExtensionColumn];
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
