#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Rate term whose size changes with temperature. The regressor is (T - 20 degC) / 64 degC times
/// dT/dt / (8 degC/min): exact factors, one rounding, at most 110/64 * 32/8 = 6.9.
template <class N>
class TemperatureRateProduct : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "temperature_rate_product",
      5,
      "temperature dependence of the rate term (thermo-optic coefficient, coating modulus)",
      "b = K1 (T - 20 degC) dT/dt",
      "K1 1e-3 to 1e-2 of the rate term's K per degC; 0.005 to 0.04 deg/h at 0.5 degC/min",
      "K1=1e-3",
      "the offset in a ramp is larger cold than hot, or the reverse, at the same ramp rate",
      "FBG thermo-optic measurements -30 to 80 degC; Bradley et al., JLT 2020"};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"K1", "deg/h per (degC^2/min)", 9, Multiplies::temperature_rate}}};

  explicit TemperatureRateProduct(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto reference = from_integer<typename N::Temperature>(20);
    regressors[0] = saturate_to<typename N::Regressor>(
        divide_by_power_of_two<9>((signals.temperature - reference) * signals.temperature_rate));
  }
};

}  // namespace fog::effects
