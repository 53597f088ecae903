#include "recording/segments.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "recording/board_limits.hpp"
#include "recording/decision_rules.hpp"
#include "support/evidence.hpp"
#include "support/statistics.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

/// One soak or ramp of a chamber programme.
struct ProgrammePart {
  SegmentKind kind = SegmentKind::soak;
  RowRange rows;
};

constexpr std::size_t kMaxPoints = 4000;

using Point = TemperaturePoint;

std::vector<Point> decimate(const Recording& recording, RowRange rows) {
  const std::size_t step = (rows.size() + kMaxPoints - 1) / kMaxPoints;
  std::vector<Point> points;
  for (std::size_t first = rows.first; first < rows.end; first += step) {
    const std::size_t end = std::min(first + step, rows.end);
    double sum_degc = 0;
    for (std::size_t row = first; row < end; ++row) sum_degc += recording.temperature_degc[row];
    points.push_back({(recording.time_s[first] + recording.time_s[end - 1]) / 2,
                      sum_degc / static_cast<double>(end - first), first});
  }
  return points;
}

// Noise of the points, from second differences, which do not contain a ramp.
double noise_degc(const std::vector<Point>& points) {
  const double kWhiteGain = std::sqrt(6.0);
  std::vector<double> bends;
  for (std::size_t i = 2; i < points.size(); ++i) {
    bends.push_back(std::fabs(points[i].temperature_degc - 2 * points[i - 1].temperature_degc +
                              points[i - 2].temperature_degc));
  }
  return sigma_by_median(std::move(bends)) / kWhiteGain;
}

// Smallest step of the sensor: 0.0625 degC for many digital ones, nearly 0 for others.
double resolution_degc(const Recording& recording, RowRange rows) {
  if (recording.temperature_period_s > 0) return recording.temperature_step_degc;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t row = rows.first + 1; row < rows.end; ++row) {
    const double step =
        std::fabs(recording.temperature_degc[row] - recording.temperature_degc[row - 1]);
    if (step > 0 && step < smallest) smallest = step;
  }
  return std::isfinite(smallest) ? smallest : 0;
}

// Largest deviation of the temperature from a straight line that does not count as a corner.
double tolerance_degc(const Recording& recording, RowRange rows, const std::vector<Point>& points) {
  return std::max({rules::kMinToleranceDegc, kCertainSigmas * noise_degc(points),
                   rules::kToleranceSteps * resolution_degc(recording, rows)});
}

// Corners of a polygon within the tolerance of all points (Ramer, Douglas, Peucker).
std::vector<std::size_t> find_corners(const std::vector<Point>& points, double tolerance) {
  std::vector<std::size_t> corners{0, points.size() - 1};
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Point& a = points[first];
    const double slope = (points[last].temperature_degc - a.temperature_degc) /
                         std::max(points[last].time_s - a.time_s, 1e-9);
    double farthest = tolerance;
    std::size_t corner = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double on_line = a.temperature_degc + slope * (points[i].time_s - a.time_s);
      const double distance = std::fabs(points[i].temperature_degc - on_line);
      if (distance > farthest) {
        farthest = distance;
        corner = i;
      }
    }
    if (corner == first) continue;
    corners.push_back(corner);
    open.emplace_back(first, corner);
    open.emplace_back(corner, last);
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// From one corner to another.
struct Piece {
  Point from;
  Point to;
  SegmentKind kind;

  double change_degc() const { return to.temperature_degc - from.temperature_degc; }
  double duration_s() const { return to.time_s - from.time_s; }
};

SegmentKind ramp_of(double change_degc) {
  return change_degc > 0 ? SegmentKind::ramp_up : SegmentKind::ramp_down;
}

// A soak stands: a change as large as a ramp's is one, however long it takes.
SegmentKind kind_by_slope(const Point& from, const Point& to, double min_ramp_degc) {
  const double change_degc = to.temperature_degc - from.temperature_degc;
  const double minutes = (to.time_s - from.time_s) / kSecondsPerMinute;
  const double fast_degc = rules::kMinRampDegcPerMin * minutes;
  if (std::fabs(change_degc) < std::min(fast_degc, min_ramp_degc)) return SegmentKind::soak;
  return ramp_of(change_degc);
}

std::vector<Piece> with_equal_neighbours_joined(const std::vector<Piece>& pieces) {
  std::vector<Piece> joined;
  for (const Piece& piece : pieces) {
    if (!joined.empty() && joined.back().kind == piece.kind) {
      joined.back().to = piece.to;
    } else {
      joined.push_back(piece);
    }
  }
  return joined;
}

// A small move is control action or overshoot of the chamber, not a ramp; and when those are
// joined, neighbours that each stand may move together.
std::vector<Piece> with_ramps_by_size(std::vector<Piece> pieces, double min_ramp_degc) {
  const auto is_small = [&](const Piece& piece) {
    return std::fabs(piece.change_degc()) < min_ramp_degc;
  };
  for (Piece& piece : pieces) {
    if (is_small(piece)) piece.kind = SegmentKind::soak;
  }
  pieces = with_equal_neighbours_joined(pieces);
  for (Piece& piece : pieces) {
    if (!is_small(piece)) piece.kind = ramp_of(piece.change_degc());
  }
  return with_equal_neighbours_joined(pieces);
}

// A short rest is a bend of the preceding ramp (at the start: of the following one), not a soak.
std::vector<Piece> without_short_soaks(std::vector<Piece> pieces) {
  if (pieces.size() < 2) return pieces;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kind != SegmentKind::soak || pieces[i].duration_s() >= rules::kMinSoakS) continue;
    pieces[i].kind = pieces[i == 0 ? 1 : i - 1].kind;
  }
  return with_equal_neighbours_joined(pieces);
}

// Divides the rows into soaks and ramps by their temperature. A ramp changes by at least 2 degC at
// 0.05 degC/min or more; a soak lasts at least 2 min unless it is the only part. A ramp ends when
// the temperature has settled to about 0.5 degC, so the tail of a chamber with a time constant
// belongs to it. Noise and resolution of the sensor raise these limits as necessary.
std::vector<ProgrammePart> find_programme_parts(const Recording& recording, RowRange rows) {
  const TemperaturePolygon polygon = temperature_polygon(recording, rows);
  const std::vector<Point>& corners = polygon.corners;
  if (corners.size() < 2) return {{SegmentKind::soak, rows}};
  const double min_ramp_degc = polygon.min_ramp_degc();

  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const SegmentKind kind = kind_by_slope(corners[i - 1], corners[i], min_ramp_degc);
    pieces.push_back({corners[i - 1], corners[i], kind});
  }
  pieces = with_equal_neighbours_joined(pieces);
  pieces = with_ramps_by_size(std::move(pieces), min_ramp_degc);
  pieces = without_short_soaks(std::move(pieces));

  std::vector<ProgrammePart> parts;
  for (const Piece& piece : pieces) {
    parts.push_back({piece.kind, {piece.from.first_row, piece.to.first_row}});
  }
  parts.back().rows.end = rows.end;
  return parts;
}

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
  for (const RowRange& programme : cut_at_gaps(recording, all, rules::kMaxUsualPeriodS)) {
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
  std::vector<Recording::Label> labels = recording.labels;
  if (labels.front().first_row > 0) labels.insert(labels.begin(), {0, ""});
  labels.push_back({recording.rows(), ""});
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < labels.size(); ++i) {
    const std::string name = labels[i].text.empty() ? "unlabelled" : labels[i].text;
    const RowRange range{labels[i].first_row, labels[i + 1].first_row};
    for (const RowRange& rows : cut_at_gaps(recording, range, rules::kMaxDropoutS)) {
      segments.push_back(segment_of(recording, name, kind_of(recording, rows), rows));
    }
  }
  return segments;
}

std::vector<Segment> with_repeated_names_numbered(std::vector<Segment> segments) {
  std::map<std::string, int> times;
  for (Segment& segment : segments) {
    const int time = ++times[segment.name];
    if (time > 1) segment.name += format(" (%d)", time);
  }
  return segments;
}

constexpr double kDayS = 24 * kSecondsPerHour;

std::vector<double> slopes_degc_per_s(const TemperaturePolygon& polygon) {
  std::vector<double> slopes;
  for (std::size_t i = 1; i < polygon.corners.size(); ++i) {
    const Point& from = polygon.corners[i - 1];
    const Point& to = polygon.corners[i];
    slopes.push_back((to.temperature_degc - from.temperature_degc) / (to.time_s - from.time_s));
  }
  return slopes;
}

bool stands(const TemperaturePolygon& polygon) {
  const auto [min, max] = std::minmax_element(
      polygon.corners.begin(), polygon.corners.end(),
      [](const auto& a, const auto& b) { return a.temperature_degc < b.temperature_degc; });
  return polygon.corners.empty() ||
         max->temperature_degc - min->temperature_degc < polygon.min_ramp_degc();
}

// The last pieces may stand: a change within the tolerance has no direction.
bool is_settling(const TemperaturePolygon& polygon) {
  constexpr std::size_t kMinPieces = 3;
  const std::vector<double> slopes = slopes_degc_per_s(polygon);
  if (slopes.size() < kMinPieces) return false;
  for (std::size_t i = 1; i < slopes.size(); ++i) {
    const double length_s = polygon.corners[i + 1].time_s - polygon.corners[i].time_s;
    const bool turns = slopes[i] * slopes[0] < 0;
    if (turns && std::fabs(slopes[i]) * length_s > polygon.tolerance_degc) return false;
    if (std::fabs(slopes[i]) >= std::fabs(slopes[i - 1])) return false;
  }
  return true;
}

bool goes_both_ways(const std::vector<Segment>& segments) {
  const auto has = [&](SegmentKind kind) {
    return std::any_of(segments.begin(), segments.end(),
                       [kind](const Segment& one) { return one.kind == kind; });
  };
  return has(SegmentKind::ramp_up) && has(SegmentKind::ramp_down);
}

bool is_of_day(const Recording& recording, const std::vector<Segment>& segments,
               const TemperaturePolygon& polygon) {
  const auto& degc = recording.temperature_degc;
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  double steepest = 0;
  for (const double slope : slopes_degc_per_s(polygon)) {
    steepest = std::max(steepest, std::fabs(slope));
  }
  return recording.time_s.back() - recording.time_s.front() >= kDayS / 2 &&
         goes_both_ways(segments) && steepest <= (*max - *min) / (kDayS / 4);
}

// Ramps of a chamber end at soaks.
bool ever_stands(const TemperaturePolygon& polygon) {
  for (std::size_t i = 1; i < polygon.corners.size(); ++i) {
    const Point& from = polygon.corners[i - 1];
    const Point& to = polygon.corners[i];
    const double change_degc = std::fabs(to.temperature_degc - from.temperature_degc);
    if (change_degc <= polygon.tolerance_degc && to.time_s - from.time_s >= rules::kMinSoakS)
      return true;
  }
  return false;
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
  return with_repeated_names_numbered(recording.labels.empty() ? segments_by_temperature(recording)
                                                               : segments_by_label(recording));
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

double TemperaturePolygon::min_ramp_degc() const {
  return std::max(rules::kMinRampDegc, rules::kMinRampTolerances * tolerance_degc);
}

TemperaturePolygon temperature_polygon(const Recording& recording, RowRange rows) {
  const std::vector<Point> points = decimate(recording, rows);
  TemperaturePolygon polygon;
  polygon.tolerance_degc = tolerance_degc(recording, rows, points);
  if (points.size() < 2) return polygon;
  for (const std::size_t corner : find_corners(points, polygon.tolerance_degc)) {
    polygon.corners.push_back(points[corner]);
  }
  return polygon;
}

const char* course_name(TemperatureCourse course) {
  constexpr const char* kNames[] = {"table", "steady", "settling", "day", "free", "programme"};
  return kNames[static_cast<std::size_t>(course)];
}

TemperatureCourse temperature_course(const Recording& recording) {
  if (recording.is_table) return TemperatureCourse::table;
  const TemperaturePolygon polygon = temperature_polygon(recording, {0, recording.rows()});
  if (stands(polygon)) return TemperatureCourse::steady;
  const std::vector<Segment> segments = find_segments(recording);
  if (is_settling(polygon)) return TemperatureCourse::settling;
  if (is_of_day(recording, segments, polygon)) return TemperatureCourse::day;
  const bool is_free = !ever_stands(polygon) && goes_both_ways(segments);
  return is_free ? TemperatureCourse::free : TemperatureCourse::programme;
}

double settling_time_s(const Recording& recording) {
  const auto& degc = recording.temperature_degc;
  const double way_degc = (1 - std::exp(-1.0)) * (degc.back() - degc.front());
  const auto there = std::find_if(degc.begin(), degc.end(), [&](double each) {
    return std::fabs(each - degc.front()) >= std::fabs(way_degc);
  });
  return recording.time_s[static_cast<std::size_t>(there - degc.begin())] -
         recording.time_s.front();
}

}  // namespace fogcomp::recording
