#pragma once

#include <cstdint>

#include "recording/recording.hpp"

namespace fogcomp::recording {

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
