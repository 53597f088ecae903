#pragma once

#include <cstddef>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::recording {

/// One soak or ramp of a chamber programme.
struct ProgrammePart {
  SegmentKind kind = SegmentKind::soak;
  RowRange rows;
};

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
};
TemperaturePolygon temperature_polygon(const Recording& recording, RowRange rows);

/// Divides the rows into soaks and ramps by their temperature. A ramp changes by at least 2 degC at
/// 0.05 degC/min or more; a soak lasts at least 2 min unless it is the only part. A ramp ends when
/// the temperature has settled to about 0.5 degC, so the tail of a chamber with a time constant
/// belongs to it. Noise and resolution of the sensor raise these limits as necessary.
std::vector<ProgrammePart> find_programme_parts(const Recording& recording, RowRange rows);

}  // namespace fogcomp::recording
