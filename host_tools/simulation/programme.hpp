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

/// Reads a chamber programme, one statement a line, `#` starts a comment:
///
///   start 20 degC                       first of all: gyro and chamber at rest at this temperature
///   segment NAME                        names what follows
///   soak 2 h                            holds the set point (units s, min, h)
///   ramp to -40 degC at 0.5 degC/min    moves it in a straight line
///   step to 60 degC                     moves it at once; takes no time by itself
///   random_steps 10 degC to 30 degC at 3 degC/min every 15 min for 10 h
///   power on | off                      no rows while off; then the recording has uptime_s
///   heater 2 W                          on the spool
///   axis up | down | north | south | east | west
///   rate 10 deg/s                       of the rate table (units deg/s, deg/h)
///   sweep 50 deg/s every 60 s           a sinusoid of the rate about 0, until the next rate
///   vibration 0.5 g                     rms
///   field 100 uT
///   azimuth 90 deg                      of the gyro about the vertical
///   repeat 3 ... end                    may be nested
///
/// A number and its unit may be written together (2h). `seed` determines the random steps; `name`
/// is the file in errors. Throws InputError `NAME:LINE: what is wrong; what to do` for anything
/// else, for temperatures outside -100 .. 150 degC, and for a programme of zero length or more than
/// 10 000 h.
Programme parse_profile(const std::string& text, const std::string& name, std::uint64_t seed);

}  // namespace fogcomp::simulation
