#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// The loop divides by a gain that was calibrated as 1.
class ScaleFactor : public Effect {
 public:
  ScaleFactor(const Parameters& parameters, const EffectContext&)
      : gain_(1 - parameters["ppm"] * 1e-6) {}

  double step(const GyroState& state) override {
    return state.input_rate_dph / gain_ - state.input_rate_dph;
  }

 private:
  double gain_;
};

}  // namespace

EffectDescription scale_factor_effect() {
  return {
      "scale_factor",
      "what the calibration left of the scale factor; needs an input rate",
      {peak_parameter(), scale_parameter(), {"ppm", "ppm", 100, -1e5, 1e5, "of the input rate"}},
      make_effect<ScaleFactor>};
}

}  // namespace fogcomp::simulation
