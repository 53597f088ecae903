#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// The two ramps of the closed loop differ in gain; near zero its noise mixes them, which rounds the
// corner to a hyperbola.
class ScaleFactorAsymmetry : public Effect {
 public:
  ScaleFactorAsymmetry(const Parameters& parameters, const EffectContext&)
      : difference_(parameters["ppm"] * 1e-6),
        rounded_dph_(parameters["rounded_dps"] * kDphPerDegreePerSecond) {}

  double step(const GyroState& state) override {
    return difference_ * (std::hypot(state.input_rate_dph, rounded_dph_) - rounded_dph_);
  }

 private:
  double difference_;
  double rounded_dph_;
};

}  // namespace

EffectDescription scale_factor_asymmetry_effect() {
  return {"scale_factor_asymmetry",
          "gain that differs with the sense of rotation; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"ppm", "ppm", 20, -1e5, 1e5, "half of the difference"},
           {"rounded_dps", "deg/s", 0.01, 1e-6, 100, "width of the rounded corner"}},
          make_effect<ScaleFactorAsymmetry>};
}

}  // namespace fogcomp::simulation
