#include "recording/reading.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

Recording read_inputs(const ReadOptions& options) {
  ReadOptions of_inputs;
  of_inputs.columns = options.join_columns;
  of_inputs.decimal_comma = options.decimal_comma;
  of_inputs.skip_bad_rows = options.skip_bad_rows;
  of_inputs.watch = options.watch;
  of_inputs.without_rate = true;
  of_inputs.keep_refused_rows = true;
  of_inputs.every_row = true;
  return read_recording(options.join, of_inputs);
}

// What is added to the times of `inputs` to make them those of `recording`.
double shift_s(const Recording& recording, const Recording& inputs) {
  if (recording.power_on_unknown != inputs.power_on_unknown) {
    const bool dates_here = recording.power_on_unknown;
    throw InputError(inputs.file, "counts its times from " +
                                      std::string(dates_here ? "power-on" : "1970") + ", " +
                                      recording.file + (dates_here ? " has dates" : " does not") +
                                      "; give both the same clock");
  }
  return inputs.first_date_s - recording.first_date_s;
}

void require_common_time(const Recording& recording, const Recording& inputs, double moved_s) {
  const double from_s = inputs.time_s.front() + moved_s;
  const double to_s = inputs.time_s.back() + moved_s;
  if (from_s <= recording.time_s.back() && to_s >= recording.time_s.front()) return;
  throw InputError(
      inputs.file,
      format("has times from %.10g to %.10g s, and %s from %.10g to %.10g s: they have "
             "none in common",
             from_s, to_s, recording.file.c_str(), recording.time_s.front(),
             recording.time_s.back()));
}

std::vector<double> readings_in_rows(const std::vector<double>& time_s, const Recording& inputs,
                                     const std::vector<double>& readings, double moved_s) {
  std::vector<double> column(time_s.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const double reading_s = inputs.time_s[i] + moved_s;
    const auto row = std::lower_bound(time_s.begin(), time_s.end(), reading_s);
    if (row == time_s.end()) break;
    if (*row - reading_s > kHoldSeconds) continue;
    column[static_cast<std::size_t>(row - time_s.begin())] = readings[i];
  }
  return column;
}

}  // namespace

void join_file(Recording& recording, LineNumbers& lines, const ReadOptions& options) {
  const Recording inputs = read_inputs(options);
  const double moved_s = shift_s(recording, inputs);
  require_common_time(recording, inputs, moved_s);
  std::vector<std::string> joined;
  for (const ColumnInfo& info : kColumns) {
    const std::vector<double>& readings = inputs[info.column];
    const bool is_input = info.column != Column::time_s && info.column != Column::rate_dph;
    if (!is_input || readings.empty() || !recording[info.column].empty()) continue;
    recording[info.column] = readings_in_rows(recording.time_s, inputs, readings, moved_s);
    joined.emplace_back(info.name);
  }
  if (joined.empty()) {
    throw InputError(inputs.file,
                     "has no column that " + recording.file + " lacks; leave --join out");
  }
  options.watch.say(recording.file, "joined with " + inputs.file + ": " + join(joined, ", "));
  complete_sparse_columns(recording, lines, options.watch);
}

}  // namespace fogcomp::recording
