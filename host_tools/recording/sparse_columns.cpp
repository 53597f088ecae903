#include "recording/sparse_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "recording/row_removal.hpp"
#include "recording/sparse_input_rate.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::size_t readings_in(const std::vector<double>& column) {
  return static_cast<std::size_t>(
      std::count_if(column.begin(), column.end(), [](double value) { return !std::isnan(value); }));
}

void join_readings(const std::vector<double>& time_s, std::vector<double>& column,
                   std::size_t before, std::size_t after) {
  const double length_s = time_s[after] - time_s[before];
  if (length_s > rules::kMaxBridgeS) return;
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

void complete(const std::vector<double>& time_s, std::vector<double>& column, bool is_uptime) {
  const std::size_t rows = column.size();
  std::size_t last = rows;  // the last reading; none yet
  for (std::size_t row = 0; row < rows; ++row) {
    if (std::isnan(column[row])) continue;
    if (last < rows && is_uptime && column[row] < column[last]) {
      join_over_restart(time_s, column, last, row);
    } else if (last < rows) {
      join_readings(time_s, column, last, row);
    }
    last = row;
  }
  for (std::size_t row = last + 1; row < rows; ++row) {
    if (time_s[row] - time_s[last] <= rules::kMaxBridgeS) column[row] = column[last];
  }
}

// A row is useless without these.
bool is_needed(Column column) {
  return column == Column::temperature_degc || column == Column::input_rate_dph;
}

LineNumbers lines_without(const LineNumbers& lines, std::size_t rows,
                          const std::vector<std::size_t>& removed) {
  LineNumbers left;
  std::size_t kept = 0;
  auto next = removed.begin();
  for (std::size_t row = 0; row < rows; ++row) {
    if (next != removed.end() && *next == row) {
      ++next;
    } else {
      left.add(kept++, lines.line_of(row));
    }
  }
  return left;
}

void say_how_sparse(const Recording& recording, const ColumnInfo& info, std::size_t readings,
                    const ReadWatch& watch) {
  const double one_in = static_cast<double>(recording.rows()) / static_cast<double>(readings);
  const char* const line =
      info.column == Column::input_rate_dph ? "a smooth curve" : "a straight line";
  watch.say(recording.file,
            format("%s: a reading in %zu of %zu samples (1 in %.3g), between them on %s",
                   std::string(info.name).c_str(), readings, recording.rows(), one_in, line));
}

void mask_unknown(Recording& recording, const std::vector<Mask>& unknown, const ReadWatch& watch) {
  if (unknown.empty()) return;
  double length_s = 0;
  for (const Mask& mask : unknown) length_s += mask.to_s - mask.from_s;
  watch.say(
      recording.file,
      format("input_rate_dph: fits and comparisons leave out %.4g s in which it changed between "
             "readings, the first at %.6g s; record it with every sample",
             length_s, unknown.front().from_s));
  recording.masks.insert(recording.masks.end(), unknown.begin(), unknown.end());
}

std::vector<std::size_t> incomplete_rows(const Recording& recording) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < recording.rows(); ++row) {
    for (const ColumnInfo& info : kColumns) {
      const std::vector<double>& column = recording[info.column];
      if (column.empty() || !is_needed(info.column) || !std::isnan(column[row])) continue;
      rows.push_back(row);
      break;
    }
  }
  return rows;
}

}  // namespace

void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch) {
  for (const ColumnInfo& info : kColumns) {
    std::vector<double>& column = recording[info.column];
    const std::size_t readings = readings_in(column);
    if (readings == column.size()) continue;
    if (readings == 0 && info.column == Column::temperature_degc) {
      throw InputError(recording.file, std::string(info.name) + " has no value in any sample");
    }
    std::vector<Mask> unknown;
    if (readings > 0 && info.column == Column::input_rate_dph) {
      unknown = complete_input_rate(recording.time_s, recording.rate_dph, column);
    } else if (readings > 0) {
      complete(recording.time_s, column, info.column == Column::uptime_s);
    }
    const bool complete_now = readings_in(column) == column.size();
    if (readings > 0 && (complete_now || is_needed(info.column))) {
      say_how_sparse(recording, info, readings, watch);
      if (info.column == Column::input_rate_dph) mask_unknown(recording, unknown, watch);
    } else {
      watch.say(recording.file,
                std::string(info.name) + format(" has a value in %zu of %zu samples: "
                                                "the column is ignored",
                                                readings, column.size()));
      column.clear();
    }
  }
  const std::vector<std::size_t> removed = incomplete_rows(recording);
  if (removed.empty()) return;
  watch.say(recording.file,
            counted(removed.size(), "sample") +
                format(" left out: no temperature or input rate within %g s, the first at line %zu",
                       rules::kMaxBridgeS, lines.line_of(removed.front())));
  recording.empty_rows += removed.size();
  lines = lines_without(lines, recording.rows(), removed);
  remove_rows(recording, removed);
  if (recording.rows() == 0)
    throw InputError(recording.file, "no sample is left; see the lines above");
}

}  // namespace fogcomp::recording
