#pragma once

#include <string>

#include "planning/operating_box.hpp"
#include "recording/recording.hpp"
#include "simulation/programme.hpp"

namespace fogcomp::planning {

/// What a gyro with the housing and coil of the simulator's defaults records in a programme, with a
/// thermometer without error; its rates are 0. Rows of `row_s`, all columns.
recording::Recording typical_recording(const simulation::Programme& programme,
                                       const std::string& name, double row_s);

/// The same of a day in the box: twelve moves to temperatures that cover it, its edges included, at
/// its fastest ramps and slower ones, with 8 h of soaks between and input rates that change.
recording::Recording typical_day(const OperatingBox& box, double row_s);

}  // namespace fogcomp::planning
