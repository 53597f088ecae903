#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fogcomp::simulation {

/// Where the gyro's sensitive axis points.
enum class Axis : std::uint8_t { up, down, north, south, east, west };

/// What the operator sets beside the temperature; holds until changed.
struct Conditions {
  bool powered = true;
  double heater_w = 0;  ///< on the spool
  double table_rate_dph = 0;
  double sweep_dph = 0;  ///< amplitude of a sinusoid on top of it, 0 at sweep_from_s
  double sweep_period_s = 1;
  double sweep_from_s = 0;
  double vibration_grms = 0;  ///< on top of the chamber's own
  double field_ut = 0;        ///< a coil's field along the azimuth's zero, on top of the Earth's
  double azimuth_deg = 0;     ///< of the gyro about the vertical
  Axis axis = Axis::up;
};

/// The table's rate while these conditions hold.
double table_rate_dph(const Conditions& conditions, double time_s);

/// A stretch of time in which the chamber's set point moves in a straight line.
struct Leg {
  double start_s = 0;
  double end_s = 0;
  double from_degc = 20;
  double to_degc = 20;
  Conditions conditions;
  std::string segment;  ///< name of the segment it belongs to
};

/// A test programme: what the chamber and the operator do, second by second. Made by
/// parse_profile().
struct Programme {
  double start_degc = 20;  ///< of everything, at time 0
  std::vector<Leg> legs;   ///< without gaps, the first from time 0
  bool sets_axis = false;  ///< the profile names an axis
  bool sets_rate = false;  ///< the profile turns a rate table

  double duration_s() const { return legs.empty() ? 0 : legs.back().end_s; }
};

}  // namespace fogcomp::simulation
