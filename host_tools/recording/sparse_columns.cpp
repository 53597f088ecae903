#include "recording/reading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_range.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::vector<bool> is_read(const std::vector<double>& column) {
  std::vector<bool> read(column.size());
  for (std::size_t row = 0; row < column.size(); ++row) read[row] = !std::isnan(column[row]);
  return read;
}

std::size_t readings_in(const std::vector<double>& column) {
  return static_cast<std::size_t>(
      std::count_if(column.begin(), column.end(), [](double value) { return !std::isnan(value); }));
}

// Two readings that differ by at most `step` are joined however far they are apart: a logger that
// writes a value when it changes had no other between them.
void join_readings(const std::vector<double>& time_s, std::vector<double>& column,
                   std::size_t before, std::size_t after, double step, double longest_s) {
  const double length_s = time_s[after] - time_s[before];
  const bool is_step = step > 0 && std::fabs(column[after] - column[before]) <= step;
  if (length_s > longest_s && !is_step) return;
  for (std::size_t row = before + 1; row < after; ++row) {
    const double part = (time_s[row] - time_s[before]) / length_s;
    column[row] = column[before] + part * (column[after] - column[before]);
  }
}

// The power was off in the longest pause between two readings: the uptime grows up to it, and
// from 0 after it.
void join_over_restart(const std::vector<double>& time_s, std::vector<double>& uptime_s,
                       std::size_t before, std::size_t after) {
  std::size_t on = after;
  for (std::size_t row = before + 1; row < after; ++row) {
    if (time_s[row] - time_s[row - 1] > time_s[on] - time_s[on - 1]) on = row;
  }
  for (std::size_t row = before + 1; row < after; ++row) {
    uptime_s[row] = row < on ? uptime_s[before] + (time_s[row] - time_s[before])
                             : std::max(0.0, uptime_s[after] - (time_s[after] - time_s[row]));
  }
}

// Calls join(before, after) for the rows of every two readings that follow each other. Returns the
// last reading; the number of rows if there is none.
template <class Join>
std::size_t for_each_interval(const std::vector<double>& column, Join join) {
  std::size_t last = column.size();
  for (std::size_t row = 0; row < column.size(); ++row) {
    if (std::isnan(column[row])) continue;
    if (last < column.size()) join(last, row);
    last = row;
  }
  return last;
}

void complete_restarts(const std::vector<double>& time_s, std::vector<double>& uptime_s) {
  for_each_interval(uptime_s, [&](std::size_t before, std::size_t after) {
    if (uptime_s[after] < uptime_s[before]) join_over_restart(time_s, uptime_s, before, after);
  });
}

// A row is useless without these.
constexpr std::array kNeeded{Column::temperature_degc, Column::input_rate_dph};

bool is_needed(Column column) {
  return std::find(kNeeded.begin(), kNeeded.end(), column) != kNeeded.end();
}

void say_how_sparse(const Recording& recording, const ColumnInfo& info, std::size_t readings,
                    const ReadWatch& watch) {
  const double one_in = static_cast<double>(recording.rows()) / static_cast<double>(readings);
  const bool is_smooth = info.column == Column::input_rate_dph;
  watch.say(recording.file,
            format("%s: a reading in %zu of %zu samples (1 in %.3g), between them on a %s",
                   std::string(info.name).c_str(), readings, recording.rows(), one_in,
                   is_smooth ? "smooth curve" : "straight line"));
}

/// How a temperature is read that has readings in some rows only.
struct TemperatureRhythm {
  TemperatureRhythm(const std::vector<double>& time_s, const std::vector<double>& degc) {
    std::vector<double> intervals_s;
    std::vector<double> changes_degc;
    for_each_interval(degc, [&](std::size_t before, std::size_t after) {
      intervals_s.push_back(time_s[after] - time_s[before]);
      changes_degc.push_back(std::fabs(degc[after] - degc[before]));
    });
    if (intervals_s.empty()) return;
    set_steps(changes_degc);
    if (intervals_s.size() > 1) set_intervals(std::move(intervals_s));
  }

  /// Between two readings so far apart nothing is missing, as most of the time says.
  double longest_interval_s = kHoldSeconds;
  double period_s = 0;   ///< if most readings keep it
  double step_degc = 0;  ///< smallest difference
  /// The same if it is logged when it changes: no two readings that follow each other are equal,
  /// most differ by the smallest difference, and that is no ramp.
  double change_degc = 0;

 private:
  void set_steps(const std::vector<double>& changes_degc) {
    for (const double change : changes_degc) {
      if (change > 0 && (step_degc == 0 || change < step_degc)) step_degc = change;
    }
    constexpr double kRounding = 1e-6;
    const double usual = median(changes_degc);
    const bool any_stands = std::count(changes_degc.begin(), changes_degc.end(), 0.0) > 0;
    const bool is_step = usual <= step_degc * (1 + kRounding) && usual < rules::kMinRampDegc;
    if (!any_stands && is_step) change_degc = usual * (1 + kRounding);
  }

  void set_intervals(std::vector<double> intervals_s) {
    std::sort(intervals_s.begin(), intervals_s.end());
    double rest_s = kMost * std::accumulate(intervals_s.begin(), intervals_s.end(), 0.0);
    auto usual = intervals_s.end();
    while (rest_s > 0) rest_s -= *--usual;
    const double longest_s = rules::kMaxSpacing * *usual;
    const bool is_told = intervals_s.back() <= rules::kMaxSpacing * intervals_s.front() ||
                         intervals_s.end() - usual >= std::ptrdiff_t{rules::kMinCases};
    if (!is_told) return;
    longest_interval_s = std::max(kHoldSeconds, std::min(longest_s, rules::kMaxUsualPeriodS));
    if (*usual <= rules::kMaxSpacing * median(intervals_s)) period_s = *usual;
  }
};

// Of a file that holds its readings each row has one, however old.
void join_temperature(Recording& recording, bool is_held) {
  const TemperatureRhythm rhythm(recording.time_s, recording.temperature_degc);
  if (is_gap(rhythm.period_s, median_spacing_s(recording.time_s))) {
    recording.temperature_period_s = rhythm.period_s;
    recording.temperature_step_degc = rhythm.step_degc;
  }
  recording.temperature_is_read = is_read(recording.temperature_degc);
  join_by_lines(recording.time_s, recording.temperature_degc, rhythm.change_degc,
                is_held ? HUGE_VAL : rhythm.longest_interval_s);
}

void leave_out_incomplete_rows(Recording& recording, LineNumbers& lines, const ReadWatch& watch) {
  std::vector<std::size_t> removed;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    const auto is_lacked = [&](Column column) {
      return !recording[column].empty() && std::isnan(recording[column][row]);
    };
    if (std::any_of(kNeeded.begin(), kNeeded.end(), is_lacked)) removed.push_back(row);
  }
  if (removed.empty()) return;
  watch.say(recording.file,
            counted(removed.size(), "sample") +
                format(" left out: no temperature or input rate within %g s, the first at line %zu",
                       kHoldSeconds, lines.line_of(removed.front())));
  recording.empty_rows += removed.size();
  remove_rows(recording, lines, removed);
  if (recording.rows() == 0)
    throw InputError(recording.file, "no sample is left; see the lines above");
}

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

void join_by_lines(const std::vector<double>& time_s, std::vector<double>& column, double step,
                   double longest_s) {
  const std::size_t last = for_each_interval(column, [&](std::size_t before, std::size_t after) {
    join_readings(time_s, column, before, after, step, longest_s);
  });
  for (std::size_t row = last + 1; row < column.size(); ++row) {
    if (time_s[row] - time_s[last] <= longest_s) column[row] = column[last];
  }
}

void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch,
                             bool is_temperature_held) {
  for (const ColumnInfo& info : kColumns) {
    std::vector<double>& column = recording[info.column];
    const std::size_t readings = readings_in(column);
    if (readings == column.size()) continue;
    if (readings == 0 && info.column == Column::temperature_degc) {
      throw InputError(recording.file, std::string(info.name) + " has no value in any sample");
    }
    std::vector<Mask> unknown;
    if (info.column == Column::input_rate_dph) {
      unknown = draw_input_rate(recording.time_s, recording.rate_dph, column);
    }
    if (info.column == Column::uptime_s) complete_restarts(recording.time_s, column);
    if (info.column == Column::temperature_degc) {
      join_temperature(recording, is_temperature_held);
    } else {
      join_by_lines(recording.time_s, column);
    }
    const bool complete_now = readings_in(column) == column.size();
    if (readings > 0 && (complete_now || is_needed(info.column))) {
      say_how_sparse(recording, info, readings, watch);
      mask_unknown_input_rate(recording, unknown, "in which it changed between readings",
                              "record it with every sample", watch);
    } else {
      watch.say(recording.file,
                std::string(info.name) + format(" has a value in %zu of %zu samples: "
                                                "the column is ignored",
                                                readings, column.size()));
      column.clear();
    }
  }
  leave_out_incomplete_rows(recording, lines, watch);
}

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
