#include "recording/segments.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"
#include "recording/programme.hpp"
#include "support/median.hpp"
#include "support/text.hpp"

namespace fogcomp::recording {
namespace {

double gap_before(const Recording& recording, std::size_t row) {
  return recording.time_s[row] - recording.time_s[row - 1];
}

// Divides [0, rows) before each stretch whose gap is longer than `shortest_s`.
std::vector<RowRange> cut_at_gaps(const Recording& recording, RowRange rows, double shortest_s) {
  std::vector<RowRange> parts;
  for (const RowRange& stretch : stretches_of(recording, rows)) {
    if (!parts.empty() && gap_before(recording, stretch.first) <= shortest_s) {
      parts.back().end = stretch.end;
    } else {
      parts.push_back(stretch);
    }
  }
  return parts;
}

double median_temperature_degc(const Recording& recording, RowRange rows) {
  constexpr std::size_t kEnough = 10000;
  const std::size_t step = rows.size() / kEnough + 1;
  std::vector<double> values;
  for (std::size_t row = rows.first; row < rows.end; row += step) {
    values.push_back(recording.temperature_degc[row]);
  }
  return median(std::move(values));
}

// A ramp is named by the temperatures of the neighbouring soaks; without a soak, by its first or
// last temperature.
std::string name_of(const Recording& recording, const std::vector<ProgrammePart>& parts,
                    std::size_t i) {
  const auto level = [&](std::size_t part) {
    return std::lround(median_temperature_degc(recording, parts[part].rows));
  };
  if (parts[i].kind == SegmentKind::soak) return format("soak %ld", level(i));
  const bool soak_before = i > 0 && parts[i - 1].kind == SegmentKind::soak;
  const bool soak_after = i + 1 < parts.size() && parts[i + 1].kind == SegmentKind::soak;
  const std::vector<double>& temperature = recording.temperature_degc;
  const long from = soak_before ? level(i - 1) : std::lround(temperature[parts[i].rows.first]);
  const long to = soak_after ? level(i + 1) : std::lround(temperature[parts[i].rows.end - 1]);
  return format("ramp %ld..%ld", from, to);
}

Segment segment_of(const Recording& recording, const std::string& name, SegmentKind kind,
                   RowRange rows) {
  return {name, kind, recording.time_s[rows.first],
          recording.time_s[rows.end - 1] + recording.period_s, rows};
}

std::vector<Segment> segments_by_temperature(const Recording& recording) {
  std::vector<Segment> segments;
  const RowRange all{0, recording.rows()};
  for (const RowRange& programme : cut_at_gaps(recording, all, kHoldSeconds)) {
    const std::vector<ProgrammePart> parts = find_programme_parts(recording, programme);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string name = name_of(recording, parts, i);
      for (const RowRange& rows : cut_at_gaps(recording, parts[i].rows, rules::kMaxDropoutS)) {
        segments.push_back(segment_of(recording, name, parts[i].kind, rows));
      }
    }
  }
  return segments;
}

// Kind of the longest part of a labelled segment.
SegmentKind kind_of(const Recording& recording, RowRange rows) {
  const std::vector<ProgrammePart> parts = find_programme_parts(recording, rows);
  return std::max_element(parts.begin(), parts.end(),
                          [](const ProgrammePart& a, const ProgrammePart& b) {
                            return a.rows.size() < b.rows.size();
                          })
      ->kind;
}

std::vector<Segment> segments_by_label(const Recording& recording) {
  std::vector<RowRange> ranges;
  std::vector<std::string> names;
  if (recording.labels.front().first_row > 0) {
    ranges.push_back({0, recording.labels.front().first_row});
    names.emplace_back("unlabelled");
  }
  for (std::size_t i = 0; i < recording.labels.size(); ++i) {
    const bool last = i + 1 == recording.labels.size();
    ranges.push_back({recording.labels[i].first_row,
                      last ? recording.rows() : recording.labels[i + 1].first_row});
    const std::string& text = recording.labels[i].text;
    names.push_back(text.empty() ? "unlabelled" : text);
  }
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    for (const RowRange& rows : cut_at_gaps(recording, ranges[i], rules::kMaxDropoutS)) {
      segments.push_back(segment_of(recording, names[i], kind_of(recording, rows), rows));
    }
  }
  return segments;
}

void number_repeated_names(std::vector<Segment>& segments) {
  std::map<std::string, int> times;
  for (Segment& segment : segments) {
    const int time = ++times[segment.name];
    if (time > 1) segment.name += format(" (%d)", time);
  }
}

}  // namespace

std::vector<RowRange> stretches_of(const Recording& recording, RowRange rows) {
  std::vector<RowRange> stretches;
  std::size_t first = rows.first;
  const auto& starts = recording.stretch_starts;
  for (auto next = std::upper_bound(starts.begin(), starts.end(), rows.first);
       next != starts.end() && *next < rows.end; ++next) {
    stretches.push_back({first, *next});
    first = *next;
  }
  if (first < rows.end) stretches.push_back({first, rows.end});
  return stretches;
}

std::vector<Segment> find_segments(const Recording& recording) {
  std::vector<Segment> segments =
      recording.labels.empty() ? segments_by_temperature(recording) : segments_by_label(recording);
  number_repeated_names(segments);
  return segments;
}

std::vector<Segment> segments_on(std::vector<Segment> segments, const std::vector<double>& time_s,
                                 RowRange rows) {
  const auto row_at = [&](double start_s) {
    const auto first = time_s.begin() + static_cast<std::ptrdiff_t>(rows.first);
    const auto end = time_s.begin() + static_cast<std::ptrdiff_t>(rows.end);
    return static_cast<std::size_t>(std::lower_bound(first, end, start_s) - time_s.begin());
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    segments[i].rows.first = i == 0 ? rows.first : segments[i - 1].rows.end;
    segments[i].rows.end = i + 1 == segments.size() ? rows.end : row_at(segments[i + 1].start_s);
  }
  return segments;
}

std::vector<RowRange> unmasked_stretches(const Recording& recording) {
  const std::vector<bool> masked = covered(recording.masks, recording.time_s);
  std::vector<RowRange> unmasked;
  for (const RowRange& stretch : stretches_of(recording, {0, recording.rows()})) {
    for (std::size_t row = stretch.first; row < stretch.end; ++row) {
      if (masked[row]) continue;
      const bool begins = row == stretch.first || masked[row - 1];
      if (begins) unmasked.push_back({row, row});
      unmasked.back().end = row + 1;
    }
  }
  return unmasked;
}

}  // namespace fogcomp::recording
