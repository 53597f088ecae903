#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fogcomp::simulation {

/// Direction of the gyro's sensitive axis.
enum class Axis : std::uint8_t { up, down, north, south, east, west };

/// Conditions set by the operator beside the temperature; constant until changed.
struct Conditions {
  bool powered = true;
  double heater_w = 0;  ///< on the spool
  double table_rate_dph = 0;
  double sweep_dph = 0;  ///< amplitude of an additional sinusoid, 0 at sweep_from_s
  double sweep_period_s = 1;
  double sweep_from_s = 0;
  double vibration_grms = 0;  ///< in addition to the chamber's own
  double field_ut = 0;        ///< field of a coil along azimuth zero, in addition to the Earth's
  double azimuth_deg = 0;     ///< of the gyro about the vertical
  Axis axis = Axis::up;
};

/// Rate of the table under these conditions.
double table_rate_dph(const Conditions& conditions, double time_s);

/// An interval of time in which the chamber's set point changes linearly.
struct Leg {
  double start_s = 0;
  double end_s = 0;
  double from_degc = 20;
  double to_degc = 20;
  Conditions conditions;
  std::string segment;  ///< name of the segment it belongs to
};

/// A test programme: actions of chamber and operator over time. Made by parse_profile().
struct Programme {
  double start_degc = 20;  ///< of everything, at time 0
  std::vector<Leg> legs;   ///< without gaps, the first from time 0
  bool sets_axis = false;  ///< the profile names an axis
  bool sets_rate = false;  ///< the profile turns a rate table
  bool switches_power = false;

  double duration_s() const { return legs.empty() ? 0 : legs.back().end_s; }
};

}  // namespace fogcomp::simulation
