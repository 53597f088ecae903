#pragma once

#include <cstddef>

#include "simulation/programme.hpp"
#include "simulation/random.hpp"

namespace fogcomp::simulation {

/// The chamber at one instant: what it does to the gyro.
struct ChamberState {
  double time_s = 0;
  double air_degc = 20;
  double vibration_grms = 0;  ///< fan, compressor and what the operator adds
  double stray_field_ut = 0;  ///< of the heater's and compressor's currents
  const Leg* leg = nullptr;
};

/// Follows a programme in fixed steps: the air lags the set point, cannot change faster than the
/// machine can heat or cool, and is never quite still.
class Chamber {
 public:
  Chamber(const Programme& programme, double step_s, std::uint64_t seed);

  const ChamberState& state() const { return state_; }
  void step();

 private:
  double set_point_degc(double time_s);

  const Programme& programme_;
  double step_s_;
  Random random_;
  ChamberState state_;
  std::size_t leg_ = 0;
  std::size_t steps_ = 0;
  double quiet_air_degc_;
  double flutter_degc_ = 0;
};

}  // namespace fogcomp::simulation
