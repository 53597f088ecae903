#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Thermo-optic part of the coil integral: zero if the whole coil warms uniformly.
class Shupe : public Effect {
 public:
  Shupe(const Parameters& parameters, const EffectContext& context)
      : coil_error_(context.coil_error),
        kappa_per_k_(context.coil_error.material().thermal_phase_per_k()),
        lead_(context.coil_error.lead_dph_s_per_k(parameters["asymmetry_m"])) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    return coil_error_.rate_dph(kappa_per_k_ * thermal.coil_rate_kps()) +
           lead_ * (thermal.coil_outside_rate_kps() - thermal.coil_mean_rate_kps());
  }

 private:
  CoilError coil_error_;
  double kappa_per_k_;
  double lead_;
};

}  // namespace

EffectDescription shupe_effect() {
  return {"shupe",
          "transient gradient through the winding (Shupe 1980; IEEE 952: D_gradTdot)",
          {peak_parameter(),
           scale_parameter(),
           {"asymmetry_m", "m", 0.2, -100, 100, "offset of the fibre's midpoint"}},
          make_effect<Shupe>};
}

}  // namespace fogcomp::simulation
