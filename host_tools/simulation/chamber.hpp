#pragma once

#include <cstddef>

#include "simulation/programme.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {

/// State of the chamber at one time, as far as it affects the gyro.
struct ChamberState {
  double time_s = 0;
  double air_degc = 20;
  double vibration_grms = 0;  ///< of fan and compressor, plus the operator's
  double stray_field_ut = 0;  ///< of the currents of heater and compressor
  const Leg* leg = nullptr;
};

/// Follows a programme in fixed steps: the air lags the set point, is limited by the machine's
/// heating and cooling rates, and fluctuates a little.
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
