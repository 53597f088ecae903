#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::coverage {

/// What a gyro of this benchmark is made of. Every name is a class of the table.
struct Kind {
  std::string sensor;
  std::string noise;
  std::string programme;
  std::string power_ons;
};

/// A gyro of exactly the formula that is fitted,
///   b0 + b1 x + b2 x^2 + K dT/dt,   x = T - 20 degC,
/// with the true temperature; the thermometer rounds it and adds noise. Nothing here is the tool's:
/// neither its simulator nor its effects, so that an error in these does not hide.
struct CleanGyro {
  Kind kind;
  double b1 = 0;                               ///< deg/h/degC
  double b2 = 0;                               ///< deg/h/degC^2
  double k = 0;                                ///< deg/h per degC/min
  std::vector<recording::Recording> training;  ///< one to three power-ons
  /// Another programme over the same temperatures, after another power-on; its noise is
  /// independent.
  recording::Recording unseen;
};

/// Equal for equal arguments.
CleanGyro clean_gyro(std::uint64_t seed);

}  // namespace fogcomp::coverage
