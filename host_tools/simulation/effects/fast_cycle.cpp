#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// A disturbance with its own period: a two-point cooler, a compressor, the supply of another
// instrument. A sine and its second harmonic, independent of power-on and temperature.
class FastCycle : public Effect {
 public:
  FastCycle(const Parameters& parameters, const EffectContext&)
      : amplitude_dph_(parameters["amplitude_dph"]),
        second_(parameters["second"]),
        rad_per_s_(2 * M_PI / parameters["period_s"]),
        phase_rad_(parameters["phase_deg"] * M_PI / 180) {}

  double step(const GyroState& state) override {
    const double phase = rad_per_s_ * state.time_s + phase_rad_;
    return amplitude_dph_ * (std::sin(phase) + second_ * std::sin(2 * phase));
  }

 private:
  double amplitude_dph_;
  double second_;
  double rad_per_s_;
  double phase_rad_;
};

}  // namespace

EffectDescription fast_cycle_effect() {
  return {"fast_cycle",
          "periodic in time, minutes: a cooler or a compressor pulls at the gyro (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"amplitude_dph", "deg/h", 0.01, -1e4, 1e4, "of the first harmonic"},
           {"period_s", "s", 420, 2, 1e5, "of the cycle"},
           {"phase_deg", "deg", 0, -360, 360, "at power-on"},
           {"second", "", 0.2, 0, 1, "share of the second harmonic"}},
          make_effect<FastCycle>};
}

}  // namespace fogcomp::simulation
