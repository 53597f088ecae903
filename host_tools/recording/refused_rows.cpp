#include "recording/reading.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "recording/board_limits.hpp"
#include "recording/columns.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

std::string place_of(const Recording& recording, const LineNumbers& lines, std::size_t row) {
  return lines.empty() ? format(" at %.6g s", recording.time_s[row])
                       : format(" at line %zu", lines.line_of(row));
}

/// Texts of the messages; made while the rows still exist.
class Words {
 public:
  Words(const Recording& recording, const LineNumbers& lines, const GyroLimits& limits,
        const std::vector<RefusedRow>& refused)
      : recording_(recording), lines_(lines), limits_(limits), refused_(refused) {}

  /// "temperature 85 degC at line 901 (then lines 1801, 2701, 3601, ...) is ...".
  std::string fault(const std::vector<std::size_t>& rows, Refusal why) const {
    return value(rows.front(), why) + place(rows.front()) + others(rows) + " " +
           reason(rows.front(), why);
  }

  std::string frozen(const std::vector<RowRange>& ranges) const {
    double stood_s = 0;
    for (const RowRange& range : ranges) {
      stood_s += recording_.time_s[range.end - 1] - recording_.time_s[range.first];
    }
    return format("temperature stands still at %.6g degC%s", temperature(ranges.front().first),
                  place(ranges.front().first).c_str()) +
           (ranges.size() > 1 ? format(" (the first of %zu times)", ranges.size()) : "") +
           format(
               ", %.4g s in all, as no working sensor does; the board would reject it; "
               "the samples are kept",
               stood_s);
  }

  std::string stuck(const ColumnInfo& info, const std::vector<RowRange>& ranges) const {
    std::size_t rows = 0;
    for (const RowRange& range : ranges) rows += range.size();
    const RowRange first = ranges.front();
    return std::string(info.name) + format(" is %.6g", recording_[info.column][first.first]) +
           place(first.first) + " and in all " + counted(rows, "row") +
           (ranges.size() > 1 ? format(" of %zu ranges", ranges.size()) : "") +
           ", where it changes from row to row otherwise: is it a reading? The samples are kept; " +
           format("--mask %.6g..%.6g leaves the first out", recording_.time_s[first.first],
                  recording_.time_s[first.end - 1]) +
           (info.column == Column::temperature_degc
                ? "; some minutes more, as dT/dt is wrong after it"
                : "");
  }

 private:
  double temperature(std::size_t row) const { return recording_.temperature_degc[row]; }

  std::string value(std::size_t row, Refusal why) const {
    const bool rate = why == Refusal::rate_beyond_range || why == Refusal::rate_jump;
    return rate ? format("rate %.6g deg/h", recording_.rate_dph[row])
                : format("temperature %.6g degC", temperature(row));
  }

  std::string place(std::size_t row) const { return place_of(recording_, lines_, row); }

  std::string others(const std::vector<std::size_t>& rows) const {
    constexpr std::size_t kMaxNamed = 4;
    std::string list;
    for (std::size_t i = 1; i < std::min(rows.size(), kMaxNamed); ++i) {
      list += i == 1 ? "" : ", ";
      list += lines_.empty() ? format("%.6g", recording_.time_s[rows[i]])
                             : std::to_string(lines_.line_of(rows[i]));
    }
    if (list.empty()) return "";
    return format(" (then %s%s%s)", lines_.empty() ? "at s " : "", list.c_str(),
                  rows.size() > kMaxNamed ? ", ..." : "");
  }

  bool is_refused(std::size_t row) const {
    return std::binary_search(refused_.begin(), refused_.end(), RefusedRow{row, {}},
                              [](RefusedRow a, RefusedRow b) { return a.row < b.row; });
  }

  // Relative to the last kept row, or else to the next one.
  double jump_degc(std::size_t row) const {
    std::size_t kept = row;
    while (kept > 0 && is_refused(kept)) --kept;
    while (kept + 1 < recording_.rows() && is_refused(kept)) ++kept;
    return std::fabs(temperature(row) - temperature(kept));
  }

  std::string reason(std::size_t row, Refusal why) const {
    switch (why) {
      case Refusal::impossible_temperature:
        return format("is outside %g to %g degC", kColdestDegc, kWarmestDegc);
      case Refusal::power_on_temperature:
        return "is what a DS18B20 says before its first conversion";
      case Refusal::temperature_jump:
        return format("jumps by %.3g degC, faster than any coil", jump_degc(row));
      case Refusal::rate_beyond_range:
        return format("is beyond the full scale of %g deg/s", limits_.range_dps);
      case Refusal::rate_jump:
        return "jumps faster than the gyro can turn";
    }
    return "";
  }

  const Recording& recording_;
  const LineNumbers& lines_;
  const GyroLimits& limits_;
  const std::vector<RefusedRow>& refused_;
};

double step_at(const std::vector<double>& values, std::size_t row) {
  return std::fabs(values[row] - values[row - 1]);
}

/// Rows in which a column that changes from row to row has one value for longer than by chance.
std::vector<RowRange> held_ranges(const std::vector<double>& values) {
  std::vector<RowRange> held;
  std::size_t repeats = 0;  // beside those of long ranges
  std::size_t changes = 0;
  for (std::size_t row = 1, first = 0; row <= values.size(); ++row) {
    if (row < values.size() && values[row] == values[row - 1]) continue;
    if (row < values.size()) ++changes;
    if (row - first > kFewValues) {
      held.push_back({first, row});
    } else {
      repeats += row - first - 1;
    }
    first = row;
  }
  const double repeat_share =
      (static_cast<double>(repeats) + 1) / (static_cast<double>(changes) + 1);
  const bool changes_otherwise = repeat_share <= 0.5 && changes >= kFewValues + 2 * held.size();
  if (!changes_otherwise) return {};
  const double by_chance = std::log(static_cast<double>(changes)) / -std::log(repeat_share);
  held.erase(std::remove_if(held.begin(), held.end(),
                            [&](const RowRange& range) {
                              return static_cast<double>(range.size()) <=
                                     static_cast<double>(kFewValues) + by_chance;
                            }),
             held.end());
  return held;
}

// Of the rows at which a column changes; of at most 65537 spread over it if these are enough.
double usual_step(const std::vector<double>& values) {
  constexpr std::size_t kMaxSteps = 65536;
  std::vector<double> steps;
  for (const std::size_t every : {values.size() / kMaxSteps + 1, std::size_t{1}}) {
    if (steps.size() >= kEnoughValues) break;
    steps.clear();
    for (std::size_t row = 1; row < values.size(); row += every) {
      if (values[row] != values[row - 1]) steps.push_back(step_at(values, row));
    }
  }
  return steps.empty() ? 0 : median(std::move(steps));
}

/// Short ranges of one value that is far from the ones around, on no way from one to the other,
/// also in what was `seen` of most of that step.
struct Outliers {
  Outliers(const std::vector<double>& values, const std::vector<double>& seen, double far) {
    const auto is_far = [&](std::size_t row, std::size_t other) {
      if (other >= values.size()) return true;
      const double step = std::fabs(seen[row] - seen[other]);
      return step >= far && step > kMost * std::fabs(values[row] - values[other]);
    };
    for (std::size_t row = 1, first = 0; row <= values.size(); ++row) {
      if (row < values.size() && values[row] == values[row - 1]) continue;
      const bool is_flank = first > 0 && row < values.size() &&
                            (values[first] > values[first - 1]) == (values[row] > values[first]);
      bool is_outlier = row - first <= kFewValues && !is_flank;
      for (std::size_t i = first; i < row && is_outlier; ++i) {
        is_outlier = is_far(i, first - 1) && is_far(i, row);
      }
      if (is_outlier) each.push_back(values[first]);
      first = row;
    }
    std::sort(each.begin(), each.end());
  }

  // The one that stands there most often, and how often.
  std::pair<double, std::size_t> most_frequent() const {
    std::pair<double, std::size_t> most{0, 0};
    for (auto at = each.begin(); at != each.end();) {
      const auto end = std::upper_bound(at, each.end(), *at);
      const auto count = static_cast<std::size_t>(end - at);
      if (count > most.second) most = {*at, count};
      at = end;
    }
    return most;
  }

  std::vector<double> each{};  // of each range, sorted
};

// Of values beside `value` the nearest one.
double nearest_to(double value, const std::vector<double>& values) {
  double next = std::numeric_limits<double>::infinity();
  for (const double each : values) {
    if (each != value && std::fabs(each - value) < std::fabs(next - value)) next = each;
  }
  return next;
}

/// How often a value stands in a column.
struct Occurrence {
  Occurrence(double value, const std::vector<double>& values) {
    for (std::size_t row = 0; row < values.size(); ++row) {
      if (values[row] != value) continue;
      ++rows;
      if (row == 0 || values[row - 1] != value) ++ranges;
    }
  }
  bool is_short() const { return rows <= kFewValues * ranges; }

  std::size_t rows = 0;
  std::size_t ranges = 0;
};

bool is_noticeable(std::size_t part, std::size_t all) {
  return static_cast<double>(part) > kNoticeable * static_cast<double>(all);
}

/// The value of most outliers, if it hardly stands anywhere else, and unlike the tail of a noise is
/// more frequent than the next value by far; nothing if there is none.
std::optional<double> far_sentinel(const std::vector<double>& values,
                                   const std::vector<double>& seen) {
  const double far = rules::kMinSentinelSteps * usual_step(seen);
  if (far == 0) return std::nullopt;
  const auto [value, count] = Outliers(values, seen, far).most_frequent();
  if (count < kFewValues) return std::nullopt;
  const Occurrence found(value, values);
  if (!found.is_short()) return std::nullopt;
  const double next = nearest_to(value, values);
  const bool has_next = std::fabs(next - value) < far;
  const std::size_t others = has_next ? Occurrence(next, values).rows : 0;
  const bool is_sentinel =
      !is_noticeable(found.ranges - count, found.ranges) && !is_noticeable(others, count);
  return is_sentinel ? std::optional(value) : std::nullopt;
}

/// Whether a rate is 0, among its other values, far more often than it has the next value: of a
/// noise both are as frequent. Not if it is 0 for long, or in many rows: that is a dead band.
bool has_filled_zeros(const std::vector<double>& values) {
  const Occurrence zeros(0, values);
  if (zeros.ranges < kFewValues || !zeros.is_short() || is_noticeable(zeros.rows, values.size())) {
    return false;
  }
  const double next = nearest_to(0, values);
  const std::size_t others = Occurrence(next, values).ranges + Occurrence(-next, values).ranges;
  return !is_noticeable(others, zeros.ranges);
}

/// Those after a jump and before one are no reading, but what stands for none. Of a thermometer: a
/// temperature comes to rest by itself, yet goes on with a larger step than all others only where
/// it has moved on unseen.
std::vector<RowRange> stuck_ranges(const std::vector<double>& values, bool is_temperature) {
  std::vector<RowRange> held = held_ranges(values);
  if (held.empty()) return held;
  std::vector<bool> is_end(values.size() + 1, false);
  for (const RowRange& range : held) is_end[range.first] = is_end[range.end] = true;
  double largest = 0;
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (!is_end[row]) largest = std::max(largest, step_at(values, row));
  }
  const double usual = usual_step(values);
  const auto jumps_at = [&](std::size_t row) {
    return row == 0 || row == values.size() || step_at(values, row) >= usual;
  };
  const auto is_reading = [&](const RowRange& range) {
    if (!is_temperature) return !jumps_at(range.first) || !jumps_at(range.end);
    return range.end == values.size() || step_at(values, range.end) <= largest;
  };
  held.erase(std::remove_if(held.begin(), held.end(), is_reading), held.end());
  return held;
}

/// Its largest and smallest values, if one stands in many rows, time after time, and the value next
/// to it in few.
std::string ends_of_scale(const std::vector<double>& rate_dph) {
  const auto [min, max] = std::minmax_element(rate_dph.begin(), rate_dph.end());
  std::string ends;
  for (const double end : {*min, *max}) {
    const Occurrence found(end, rate_dph);
    const std::size_t beside = Occurrence(nearest_to(end, rate_dph), rate_dph).rows;
    if (found.rows < kFewValues || found.ranges < 2 || is_noticeable(beside, found.rows)) continue;
    ends += format("%s%.6g in %zu", ends.empty() ? "" : ", and ", end, found.rows);
  }
  return ends;
}

void name_stuck_columns(const Recording& recording, const Words& words, const ReadWatch& watch) {
  for (const ColumnInfo& info : kColumns) {
    const std::vector<double>& values = recording[info.column];
    const bool is_temperature = info.column == Column::temperature_degc;
    const bool has_own_judge = info.column == Column::time_s || info.column == Column::uptime_s ||
                               info.column == Column::input_rate_dph ||
                               (is_temperature && (recording.temperature_period_s > 0 ||
                                                   judges_frozen_temperatures(recording)));
    if (has_own_judge || values.empty()) continue;
    const std::string ends = info.column == Column::rate_dph ? ends_of_scale(values) : "";
    if (!ends.empty()) {
      watch.say(recording.file, "the rate ends at " + ends +
                                    " rows, as at the end of a scale; the samples are kept, "
                                    "--mask FROM..TO leaves some out");
      continue;
    }
    const std::vector<RowRange> ranges = stuck_ranges(values, is_temperature);
    if (!ranges.empty()) watch.say(recording.file, words.stuck(info, ranges));
  }
}

const char* likely_cause(const Recording& recording, Refusal why) {
  if (why == Refusal::rate_beyond_range || why == Refusal::rate_jump) {
    return "is rate_dph in deg/h?";
  }
  const auto [min, max] =
      std::minmax_element(recording.temperature_degc.begin(), recording.temperature_degc.end());
  return temperature_question(*min, *max);
}

void name_refused_rows(const Recording& recording, const Words& words,
                       const std::vector<RefusedRow>& refused, const ReadWatch& watch) {
  for (const Refusal why :
       {Refusal::impossible_temperature, Refusal::power_on_temperature, Refusal::temperature_jump,
        Refusal::rate_beyond_range, Refusal::rate_jump}) {
    std::vector<std::size_t> rows;
    for (const RefusedRow& each : refused) {
      if (each.why == why) rows.push_back(each.row);
    }
    if (rows.empty()) continue;
    const std::string fault = words.fault(rows, why);
    if (rows.size() == recording.rows()) {
      throw InputError(recording.file, "the board would refuse every sample: " + fault + "; " +
                                           likely_cause(recording, why));
    }
    watch.say(recording.file, counted(rows.size(), "sample") + " left out: " + fault +
                                  "; the board would refuse " + (rows.size() == 1 ? "it" : "them"));
  }
  if (refused.size() == recording.rows()) {
    throw InputError(recording.file, "no sample is left; see the lines above");
  }
}

}  // namespace

void leave_out_sentinels(Recording& recording, LineNumbers& lines, const ReadWatch& watch) {
  const auto leave_out = [&](Column column, double value, const char* why) {
    const std::vector<double>& values = recording[column];
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < recording.rows(); ++row) {
      if (values[row] == value) rows.push_back(row);
    }
    watch.say(recording.file, counted(rows.size(), "sample") + " left out: the " +
                                  (column == Column::rate_dph ? "" : "input ") +
                                  format("rate is exactly %.6g deg/h, the first", value) +
                                  place_of(recording, lines, rows.front()) + why + ": no readings");
    recording.empty_rows += rows.size();
    remove_rows(recording, lines, rows);
  };
  const auto each_far = [&](Column column, auto seen) {
    while (const auto value = far_sentinel(recording[column], seen(recording))) {
      leave_out(column, *value, ", each far from those around");
    }
  };
  each_far(Column::rate_dph,
           [](const Recording& run) -> const std::vector<double>& { return run.rate_dph; });
  if (!recording.input_rate_dph.empty()) each_far(Column::input_rate_dph, bias_dph);
  if (has_filled_zeros(recording.rate_dph)) {
    leave_out(Column::rate_dph, 0, ", far more often than any value beside it");
  }
}

void leave_out_refused_rows(Recording& recording, LineNumbers lines, const GyroLimits& limits,
                            const ReadWatch& watch) {
  const std::vector<RefusedRow> refused = refused_rows(recording, limits);
  const std::vector<RowRange> frozen = frozen_temperatures(recording);
  const Words words(recording, lines, limits, refused);
  if (!frozen.empty()) watch.say(recording.file, words.frozen(frozen));
  name_stuck_columns(recording, words, watch);
  if (refused.empty()) return;
  name_refused_rows(recording, words, refused, watch);
  std::vector<std::size_t> rows(refused.size());
  std::transform(refused.begin(), refused.end(), rows.begin(),
                 [](const RefusedRow& each) { return each.row; });
  remove_rows(recording, lines, rows);
  recording.refused_rows = refused.size();
}

}  // namespace fogcomp::recording
