#pragma once

#include <cstdint>
#include <string>

#include "simulation/programme.hpp"

namespace fogcomp::simulation {

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
