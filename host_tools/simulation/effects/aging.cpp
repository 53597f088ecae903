#include <cmath>

#include "simulation/effects/arrhenius.hpp"
#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Creep of the glue (logarithmic) and diffusion of moisture (square root of time), both faster when
// warm (Arrhenius).
class Aging : public Effect {
 public:
  Aging(const Parameters& parameters, const EffectContext&)
      : creep_dph_(parameters["creep_dph"]),
        moisture_dph_(parameters["moisture_dph"]),
        onset_s_(parameters["onset_s"]),
        activation_ev_(parameters["activation_ev"]) {}

  double step(const GyroState& state) override {
    if (state.time_s > 0) {
      age_s_ += state.step_s * arrhenius(activation_ev_, state.thermal->coil_mean_degc());
    }
    return creep_dph_ * std::log10(1 + age_s_ / onset_s_) +
           moisture_dph_ * std::sqrt(age_s_ / 86400);
  }

 private:
  double creep_dph_;
  double moisture_dph_;
  double onset_s_;
  double activation_ev_;
  double age_s_ = 0;  ///< equivalent time at 20 degC
};

}  // namespace

EffectDescription aging_effect() {
  return {"aging",
          "creep and moisture; no power cycle resets them",
          {peak_parameter(),
           scale_parameter(),
           {"creep_dph", "deg/h", 0.01, -1e3, 1e3, "per decade of time"},
           {"moisture_dph", "deg/h", 0.005, -1e3, 1e3, "after the first day, growing as its root"},
           {"onset_s", "s", 3600, 1, 1e8, "start of the logarithm"},
           {"activation_ev", "eV", 0.15, 0, 1.5, "activation energy"}},
          make_effect<Aging>};
}

}  // namespace fogcomp::simulation
