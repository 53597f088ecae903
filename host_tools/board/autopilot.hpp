#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/model.hpp"

namespace fogcomp::board {

enum class Autopilot : std::uint8_t { px4, ardupilot };

/// One axis of an IMU: its model, and the file that has it, for messages.
struct AxisModel {
  model::Model model;
  std::string file;
};

/// Parameters by which an autopilot compensates the first gyro of an IMU, axes X, Y, Z: a
/// polynomial of degree 3 in temperature. Of PX4 TC_G0_*, about 20 degC; of ArduPilot INS_TCAL1_*,
/// about its 35 degC and without the bias, which it measures at each start. Throws InputError for a
/// model that has anything else, or another degree.
std::string autopilot_parameters(Autopilot autopilot, const std::array<AxisModel, 3>& axes);

}  // namespace fogcomp::board
