#pragma once

#include "simulation/gyro_description.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {

/// A temperature sensor: follows the place where it is glued with a lag, and converts once per
/// thermal step, with noise and limited resolution. Its reading is constant between conversions.
class TemperatureSensor {
 public:
  /// `name` of the part: sensor or sensor2.
  TemperatureSensor(const Parameters& parameters, const std::string& name, std::uint64_t seed);

  /// Returns the new reading, degC.
  double step(const GyroThermalModel& thermal, double air_degc, double step_s);

 private:
  double place_degc(const GyroThermalModel& thermal, double air_degc) const;

  Random random_;
  int place_;
  double lag_s_;
  double resolution_k_;
  double noise_k_;
  double offset_k_;
  double element_degc_ = 0;
  bool started_ = false;
};

}  // namespace fogcomp::simulation
