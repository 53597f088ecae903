#pragma once

#include "simulation/effects/effect.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {

/// Field, light power, supply and vibration at the gyro. They vary whether or not an effect depends
/// on them, and may be recorded in any case.
class AmbientModel {
 public:
  explicit AmbientModel(std::uint64_t seed);

  Ambient step(const ChamberState& chamber, const GyroThermalModel& thermal, double step_s);

 private:
  Random light_random_;
  Random supply_random_;
  double light_wander_ = 0;
  double supply_wander_v_ = 0;
};

}  // namespace fogcomp::simulation
