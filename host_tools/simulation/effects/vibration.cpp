#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Dampers and glue stiffen when cold and transmit less.
constexpr double kDamping_per_k = 3e-3;

// Vibration modulates power and phase together; their product has a non-zero mean.
class Vibration : public Effect {
 public:
  Vibration(const Parameters& parameters, const EffectContext&)
      : dph_per_g2_(parameters["coefficient"]) {}

  double step(const GyroState& state) override {
    const double g = state.ambient[fog::Input::vibration];
    const double above_k = state.thermal->cover_degc() - kReference_degc;
    return dph_per_g2_ * g * g * (1 + kDamping_per_k * above_k);
  }

 private:
  double dph_per_g2_;
};

}  // namespace

EffectDescription vibration_effect() {
  return {"vibration",
          "vibration rectification, k g^2; --columns vibration records g",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/g^2", 0.02, -1e4, 1e4, "at 20 degC"}},
          make_effect<Vibration>};
}

}  // namespace fogcomp::simulation
