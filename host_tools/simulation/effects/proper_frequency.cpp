#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kSpeedOfLight_mps = 299792458.0;

// The modulation clock is constant, but the coil's proper frequency c / (2 n L) changes with
// temperature; pick-up synchronous with the modulation turns the difference into a bias.
class ProperFrequency : public Effect {
 public:
  ProperFrequency(const Parameters& parameters, const EffectContext& context)
      : dph_per_hz_(parameters["coefficient"]), detuning_hz_(parameters["detuning_hz"]) {
    const FibreMaterial& material = context.coil_error.material();
    const double optical_path_m =
        material.refractive_index * context.coil_error.coil().fibre_length_m();
    hz_per_k_ = -kSpeedOfLight_mps / (2 * optical_path_m) * material.thermal_phase_per_k() /
                material.refractive_index;
  }

  double step(const GyroState& state) override {
    const double above_k = state.thermal->coil_mean_degc() - kReference_degc;
    return dph_per_hz_ * (detuning_hz_ - hz_per_k_ * above_k);
  }

 private:
  double dph_per_hz_;
  double detuning_hz_;
  double hz_per_k_;
};

}  // namespace

EffectDescription proper_frequency_effect() {
  return {"proper_frequency",
          "modulation off the coil's proper frequency, which falls 0.8 Hz/K (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/Hz", 2e-4, -10, 10, "size of the synchronous pick-up"},
           {"detuning_hz", "Hz", 0, -1e4, 1e4, "clock less proper frequency at 20 degC"}},
          make_effect<ProperFrequency>};
}

}  // namespace fogcomp::simulation
