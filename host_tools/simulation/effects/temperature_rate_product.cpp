#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "simulation/effects/stress_kernel.hpp"

namespace fogcomp::simulation {
namespace {

// Coating and potting stiffen roughly exponentially towards low temperatures.
constexpr double kStiffening_per_k = 0.004;

// kappa depends on temperature: mainly through the modulus of coating and potting, a little through
// dn/dT of the glass.
class TemperatureRateProduct : public Effect {
 public:
  TemperatureRateProduct(const Parameters& parameters, const EffectContext& context)
      : stress_kernel_(parameters["coefficient"] * unit_stress_kernel(context.coil_error)),
        glass_kernel_(context.coil_error.kernel_dph_s() *
                      context.coil_error.material().thermo_optic_per_k *
                      context.coil_error.material().thermo_optic_slope_per_k) {}

  double step(const GyroState& state) override {
    const CellArray above_k = state.thermal->coil_degc() - kReference_degc;
    const CellArray softening = (1 - (-kStiffening_per_k * above_k).exp()) / kStiffening_per_k;
    return ((stress_kernel_ * softening + glass_kernel_ * above_k) * state.thermal->coil_rate_kps())
        .sum();
  }

 private:
  CellArray stress_kernel_;
  CellArray glass_kernel_;
};

}  // namespace

EffectDescription temperature_rate_product_effect() {
  return {"temperature_rate_product",
          "the rate term's size depends on temperature: modulus of the potting, dn/dT(T)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/(K/min)/K", 5e-4, -10, 10,
            "change of the rate term per K, at 20 degC"}},
          make_effect<TemperatureRateProduct>};
}

}  // namespace fogcomp::simulation
