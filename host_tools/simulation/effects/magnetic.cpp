#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Faraday effect in a twisted fibre: the field in the coil's plane times a sensitivity that depends
// on the gyro's azimuth (relative to the field in ambient) and temperature.
class Magnetic : public Effect {
 public:
  Magnetic(const Parameters& parameters, const EffectContext&)
      : dph_per_ut_(parameters["sensitivity"]), per_k_(parameters["temperature_slope"]) {}

  double step(const GyroState& state) override {
    const double above_k = state.thermal->coil_mean_degc() - kReference_degc;
    return dph_per_ut_ * state.ambient[fog::Input::magnetic] * (1 + per_k_ * above_k);
  }

 private:
  double dph_per_ut_;
  double per_k_;
};

}  // namespace

EffectDescription magnetic_effect() {
  return {"magnetic",
          "Faraday effect of the field in the coil's plane; --columns magnetic records the field",
          {peak_parameter(),
           scale_parameter(),
           {"sensitivity", "deg/h/uT", 6e-4, -10, 10, "0.03 deg/h in the Earth's 50 uT: shielded"},
           {"temperature_slope", "1/K", 2e-3, -0.1, 0.1, "relative change of the sensitivity"}},
          make_effect<Magnetic>};
}

}  // namespace fogcomp::simulation
