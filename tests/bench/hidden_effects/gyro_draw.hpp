#pragma once

#include <string>
#include <vector>

#include "draws.hpp"

namespace fogcomp::bench {

/// How much flicker noise a gyro has.
enum class Flicker { none, weak, strong };

/// A gyro that the declared model describes completely.
struct DrawnGyro {
  std::vector<std::string> parts;     ///< options of `simulate --effect`: coil, housing, sensor
  std::vector<std::string> effects;   ///< options of `simulate --effect`: what is declared
  std::vector<std::string> declared;  ///< for `fit --effects`, one by one
  double white_dprh = 0;
  double flicker_dph = 0;

  /// rms of the white noise of a row of 10 s, deg/h: the unit of every size in this benchmark.
  double row_noise_dph() const;
  std::string noise_option() const;
};

/// Draws a gyro whose declared model lacks `hidden`. If that is bias_temperature, a lower order is
/// declared and drawn.
DrawnGyro draw_gyro(Draws& draws, Flicker flicker, const std::vector<std::string>& hidden);

}  // namespace fogcomp::bench
