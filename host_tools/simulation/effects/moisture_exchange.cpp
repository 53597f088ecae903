#include <cmath>

#include "simulation/effects/arrhenius.hpp"
#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kStartDegc = 20;  // long before the test

// Potting gives off moisture when warm and takes it up again when cold: a lag behind the
// temperature that is slow in the cold (Arrhenius), so that heating and cooling differ.
class MoistureExchange : public Effect {
 public:
  MoistureExchange(const Parameters& parameters, const EffectContext&)
      : dph_per_k_(parameters["coefficient"]),
        tau_s_(parameters["tau_s"]),
        activation_ev_(parameters["activation_ev"]) {}

  double step(const GyroState& state) override {
    const double degc = state.thermal->coil_mean_degc();
    const double steps = state.step_s / tau_s_ * arrhenius(activation_ev_, degc);
    dry_k_ -= std::expm1(-steps) * (degc - kStartDegc - dry_k_);
    return dph_per_k_ * dry_k_;
  }

 private:
  double dph_per_k_;
  double tau_s_;
  double activation_ev_;
  double dry_k_ = 0;  // what has left, in kelvin above 20 degC at which it would rest
};

}  // namespace

EffectDescription moisture_exchange_effect() {
  return {"moisture_exchange",
          "moisture leaves the potting when warm and comes back when cold (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/K", 1e-3, -10, 10, "at rest, per kelvin above 20 degC"},
           {"tau_s", "s", 7200, 1, 1e7, "time constant at 20 degC"},
           {"activation_ev", "eV", 0.4, 0, 1.5, "activation energy of the diffusion"}},
          make_effect<MoistureExchange>};
}

}  // namespace fogcomp::simulation
