#include "simulation/effects/effect_list.hpp"
#include "simulation/effects/stress_kernel.hpp"

namespace fogcomp::simulation {
namespace {

// Mohr effect: the same temperature change strains the layers differently, so that the two halves
// of the fibre, which are in different layers, do not cancel.
class TemperatureRate : public Effect {
 public:
  TemperatureRate(const Parameters& parameters, const EffectContext& context)
      : kernel_(parameters["coefficient"] != 0
                    ? parameters["coefficient"] * unit_stress_kernel(context.coil_error)
                    : stress_kernel(context.coil_error, 1e-6 * parameters["inside_ppm"],
                                    1e-6 * parameters["outside_ppm"])) {}

  double step(const GyroState& state) override {
    return (kernel_ * state.thermal->coil_rate_kps()).sum();
  }

 private:
  CellArray kernel_;
};

}  // namespace

EffectDescription temperature_rate_effect() {
  return {
      "temperature_rate",
      "elasto-optic stress differs from layer to layer: K dT/dt (Mohr; IEEE 952: D_Tdot)",
      {peak_parameter(),
       scale_parameter(),
       {"coefficient", "deg/h/(K/min)", 0, -1e3, 1e3, "in a long ramp; 0: what the strains give"},
       {"inside_ppm", "ppm/K", 1e6 * kStrainInside, -100, 100, "strain of the innermost layer"},
       {"outside_ppm", "ppm/K", 1e6 * kStrainOutside, -100, 100, "of the outermost"}},
      make_effect<TemperatureRate>};
}

}  // namespace fogcomp::simulation
