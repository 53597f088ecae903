#include "recording/temperature_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "recording/decision_rules.hpp"
#include "recording/segments.hpp"
#include "support/units.hpp"

namespace fogcomp::recording {
namespace {

constexpr double kDayS = 24 * kSecondsPerHour;

struct Slopes {
  std::vector<double> degc_per_s;
  double max() const {
    double steepest = 0;
    for (const double slope : degc_per_s) steepest = std::max(steepest, std::fabs(slope));
    return steepest;
  }
};

Slopes slopes_of(const TemperaturePolygon& polygon) {
  Slopes slopes;
  for (std::size_t i = 1; i < polygon.corners.size(); ++i) {
    const TemperaturePoint& from = polygon.corners[i - 1];
    const TemperaturePoint& to = polygon.corners[i];
    slopes.degc_per_s.push_back((to.temperature_degc - from.temperature_degc) /
                                (to.time_s - from.time_s));
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
  const Slopes slopes = slopes_of(polygon);
  if (slopes.degc_per_s.size() < kMinPieces) return false;
  for (std::size_t i = 1; i < slopes.degc_per_s.size(); ++i) {
    const double before = std::fabs(slopes.degc_per_s[i - 1]);
    const double length_s = polygon.corners[i + 1].time_s - polygon.corners[i].time_s;
    const bool turns = slopes.degc_per_s[i] * slopes.degc_per_s[0] < 0;
    if (turns && std::fabs(slopes.degc_per_s[i]) * length_s > polygon.tolerance_degc) return false;
    if (std::fabs(slopes.degc_per_s[i]) >= before) return false;
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

double span_degc(const Recording& recording) {
  const auto& degc = recording.temperature_degc;
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  return *max - *min;
}

double length_s(const Recording& recording) {
  return recording.time_s.back() - recording.time_s.front();
}

bool is_of_day(const Recording& recording, const std::vector<Segment>& segments,
               const TemperaturePolygon& polygon) {
  return length_s(recording) >= kDayS / 2 && goes_both_ways(segments) &&
         slopes_of(polygon).max() <= span_degc(recording) / (kDayS / 4);
}

// Ramps of a chamber end at soaks.
bool ever_stands(const TemperaturePolygon& polygon) {
  for (std::size_t i = 1; i < polygon.corners.size(); ++i) {
    const TemperaturePoint& from = polygon.corners[i - 1];
    const TemperaturePoint& to = polygon.corners[i];
    const double change_degc = std::fabs(to.temperature_degc - from.temperature_degc);
    if (change_degc <= polygon.tolerance_degc && to.time_s - from.time_s >= rules::kMinSoakS)
      return true;
  }
  return false;
}

}  // namespace

const char* course_name(TemperatureCourse course) {
  switch (course) {
    case TemperatureCourse::table:
      return "table";
    case TemperatureCourse::steady:
      return "steady";
    case TemperatureCourse::settling:
      return "settling";
    case TemperatureCourse::day:
      return "day";
    case TemperatureCourse::free:
      return "free";
    case TemperatureCourse::programme:
      break;
  }
  return "programme";
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
