#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Slow residual errors of polarisation, electronics and pick-up: a smooth function of the
// temperature of their part.
class BiasTemperature : public Effect {
 public:
  BiasTemperature(const Parameters& parameters, const EffectContext&)
      : slope_(parameters["slope"]),
        curvature_(parameters["curvature"]),
        cubic_(parameters["cubic"]),
        at_optics_(parameters["at"] == 1) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    const double x =
        (at_optics_ ? thermal.optics_degc() : thermal.coil_mean_degc()) - kReference_degc;
    return x * (slope_ + x * (curvature_ + x * cubic_));
  }

 private:
  double slope_;
  double curvature_;
  double cubic_;
  bool at_optics_;
};

}  // namespace

EffectDescription bias_temperature_effect() {
  return {"bias_temperature",
          "static temperature sensitivity of the bias, zero at 20 degC (IEEE 952: D_T)",
          {peak_parameter(),
           scale_parameter(),
           {"slope", "deg/h/K", 3e-4, -1, 1, "of the temperature above 20 degC"},
           {"curvature", "deg/h/K^2", 3e-6, -1, 1, "of its square"},
           {"cubic", "deg/h/K^3", 0, -1, 1, "of its cube"},
           {"at", "", 0, 0, 0, "whose temperature counts", {"coil", "optics"}}},
          make_effect<BiasTemperature>};
}

}  // namespace fogcomp::simulation
