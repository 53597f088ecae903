#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "recording/row_range.hpp"

namespace fogcomp::recording {

enum class SegmentKind : std::uint8_t { soak, ramp_up, ramp_down };

/// A part of a run with one action of the chamber.
struct Segment {
  std::string name;  ///< unique within the run: "soak 20", "ramp 20..-40", "soak 20 (2)"
  SegmentKind kind = SegmentKind::soak;
  double start_s = 0;  ///< of its first row
  double end_s = 0;    ///< end of its last row
  RowRange rows;       ///< in the series
};

/// Soaks and ramps that cover all rows in order, from the temperature or from the file's `segment`
/// column; names have temperatures in whole degC. A gap of more than 1 s starts a new segment; in a
/// shorter one, such as a lost sample at 200 Hz, neither temperature nor drift changes.
/// (stretch_starts has every gap.)
std::vector<Segment> find_segments(const Recording& recording);

/// The same segments in another series of the same run, whose `rows` have these times: a row
/// belongs to the segment that began last. Segments shorter than a row are dropped.
std::vector<Segment> segments_on(std::vector<Segment> segments, const std::vector<double>& time_s,
                                 RowRange rows);

/// The stretches without a gap within `rows`.
std::vector<RowRange> stretches_of(const Recording& recording, RowRange rows);

/// The stretches without a gap and without a masked time, of the whole recording.
std::vector<RowRange> unmasked_stretches(const Recording& recording);

/// Mean temperature of a few rows.
struct TemperaturePoint {
  double time_s;
  double temperature_degc;
  std::size_t first_row;
};

/// Straight lines from which no temperature deviates by more than the tolerance.
struct TemperaturePolygon {
  std::vector<TemperaturePoint> corners{};  ///< first and last row among them; none for one row
  double tolerance_degc = 0;                ///< by noise and resolution of the sensor
  double min_ramp_degc() const;             ///< a smaller change is no ramp
};
TemperaturePolygon temperature_polygon(const Recording& recording, RowRange rows);

/// What moves the temperature of a recording, as far as its course shows.
enum class TemperatureCourse : std::uint8_t {
  table,      ///< nothing: each line is of a settled gyro
  steady,     ///< nothing: it stands
  settling,   ///< one step, towards which it moves ever more slowly: the gyro's own heat, a room
  day,        ///< surroundings, up and down as slowly as a day does
  free,       ///< surroundings or use: it never stands
  programme,  ///< a chamber: ramps and soaks
};

const char* course_name(TemperatureCourse course);

/// By the straight pieces of the temperature (segments.hpp) and its soaks. A settling one has at
/// least three, of one direction, each slower than the one before: a ramp and a soak are two. A
/// day's takes a quarter of a day or more for its span, and turns within the recording, which lasts
/// half a day at least.
TemperatureCourse temperature_course(const Recording& recording);

/// Seconds in which a settling temperature goes 1 - 1/e of its way: the time constant of a body
/// with one.
double settling_time_s(const Recording& recording);

}  // namespace fogcomp::recording
