#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Scale factor ~ L D / wavelength. The source's mean wavelength follows its temperature, which its
// cooler controls less accurately away from 20 degC; the coil expands with its own temperature.
class ScaleFactorTemperature : public Effect {
 public:
  ScaleFactorTemperature(const Parameters& parameters, const EffectContext&)
      : wavelength_per_k_(parameters["wavelength_ppm"] * 1e-6),
        coil_per_k_(parameters["coil_ppm"] * 1e-6) {}

  double step(const GyroState& state) override {
    const double source_k = state.thermal->optics_degc() - kReference_degc;
    const double coil_k = state.thermal->coil_mean_degc() - kReference_degc;
    const double length_ratio =
        (1 + coil_per_k_ * coil_k) / (1 + wavelength_per_k_ * source_k * (1 + 2e-3 * source_k));
    return state.input_rate_dph * (length_ratio - 1);
  }

 private:
  double wavelength_per_k_;
  double coil_per_k_;
};

}  // namespace

EffectDescription scale_factor_temperature_effect() {
  return {"scale_factor_temperature",
          "source wavelength and coil size change the scale factor; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"wavelength_ppm", "ppm/K", 5, -1000, 1000, "of the source's mean wavelength"},
           {"coil_ppm", "ppm/K", 4, -1000, 1000, "of length times diameter"}},
          make_effect<ScaleFactorTemperature>};
}

}  // namespace fogcomp::simulation
