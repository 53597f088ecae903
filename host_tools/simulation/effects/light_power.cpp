#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// The less light, the more a fixed electronic offset in the demodulated signal matters.
class LightPower : public Effect {
 public:
  LightPower(const Parameters& parameters, const EffectContext&)
      : pickup_dph_(parameters["pickup_dph"]), nominal_uw_(parameters["nominal_uw"]) {}

  double step(const GyroState& state) override {
    return pickup_dph_ * (nominal_uw_ / state.ambient[fog::Input::light_power] - 1);
  }

 private:
  double pickup_dph_;
  double nominal_uw_;
};

}  // namespace

EffectDescription light_power_effect() {
  return {"light_power",
          "electronic pick-up weighs more with less light; --columns light_power records the power",
          {peak_parameter(),
           scale_parameter(),
           {"pickup_dph", "deg/h", 0.1, -1e3, 1e3, "of the pick-up at nominal power"},
           {"nominal_uw", "uW", 100, 0.1, 1e5, "power at which the pick-up is trimmed"}},
          make_effect<LightPower>};
}

}  // namespace fogcomp::simulation
