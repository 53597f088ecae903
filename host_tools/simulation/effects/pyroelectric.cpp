#include <algorithm>
#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Charge leaks faster when warm: a decade per this many kelvin (lithium niobate, order of
// magnitude).
constexpr double kLeakDecade_k = 60;

// Lithium niobate is charged by temperature changes; above a threshold the waveguide loses light,
// and the bias shifts until the charge has leaked away.
class Pyroelectric : public Effect {
 public:
  Pyroelectric(const Parameters& parameters, const EffectContext&)
      : dph_per_k_(parameters["coefficient"]),
        threshold_k_(parameters["threshold_k"]),
        leak_s_(parameters["leak_s"]) {}

  double step(const GyroState& state) override {
    const double degc = state.thermal->optics_degc();
    if (started_) charge_k_ += degc - before_degc_;
    before_degc_ = degc;
    started_ = true;
    const double tau_s = leak_s_ * std::pow(10.0, (20 - degc) / kLeakDecade_k);
    charge_k_ *= std::exp(-state.step_s / tau_s);
    return dph_per_k_ * std::max(std::abs(charge_k_) - threshold_k_, 0.0);
  }

 private:
  double dph_per_k_;
  double threshold_k_;
  double leak_s_;
  double charge_k_ = 0;  ///< in kelvin of fast temperature change
  double before_degc_ = 0;
  bool started_ = false;
};

}  // namespace

EffectDescription pyroelectric_effect() {
  return {"pyroelectric",
          "charge in the integrated optics after fast changes in the cold (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/K", 0.01, -1e3, 1e3, "per kelvin of charge above the threshold"},
           {"threshold_k", "K", 5, 0, 100, "charge that does no harm"},
           {"leak_s", "s", 200, 1, 1e6, "time constant of the leakage at 20 degC"}},
          make_effect<Pyroelectric>};
}

}  // namespace fogcomp::simulation
