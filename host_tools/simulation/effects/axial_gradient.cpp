#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// The fibre's two ends leave the coil over different faces, so that one has the temperature of the
// lower face, the other that of the upper: n kappa d / D * d/dt(T_lower - T_upper). The difference
// itself also strains the clamped ends.
class AxialGradient : public Effect {
 public:
  AxialGradient(const Parameters& parameters, const EffectContext& context)
      : lead_(context.coil_error.lead_dph_s_per_k(parameters["asymmetry_m"]) / 2),
        stress_(parameters["stress"]) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    return lead_ * thermal.axial_difference_rate_kps() + stress_ * thermal.axial_difference_k();
  }

 private:
  double lead_;
  double stress_;
};

}  // namespace

EffectDescription axial_gradient_effect() {
  return {"axial_gradient",
          "gradient along the coil's axis; seen with --columns temperature2 and a heater profile",
          {peak_parameter(),
           scale_parameter(),
           {"asymmetry_m", "m", 1, -100, 100, "fibre on each face"},
           {"stress", "deg/h/K", 0.02, -100, 100, "of the lower face's excess over the upper's"}},
          make_effect<AxialGradient>};
}

}  // namespace fogcomp::simulation
