#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Elasto-optic thermal-stress rate error (Mohr): a uniform dT/dt strains the layers of the coil
/// unequally. The regressor is dT/dt / (4 degC/min), so it is exact (rounded to 2^-23 degC/min) up
/// to 32 degC/min.
template <class N>
class TemperatureRate : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "temperature_rate",
      2,
      "elasto-optic thermal-stress rate error, quasi-static (Mohr)",
      "b = K dT/dt",
      "K 0.05 to 0.3 deg/h per (degC/min)",
      "K=0.136",
      "constant offset during a ramp, sign flips between heating and cooling, zero in soaks",
      "Mohr & Schadt, Proc. SPIE 5502, 410 (2004); IEEE Std 952, D_Tdot"};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"K", "deg/h per (degC/min)", 2, Multiplies::temperature_rate}}};

  explicit TemperatureRate(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    regressors[0] =
        saturate_to<typename N::Regressor>(divide_by_power_of_two<2>(signals.temperature_rate));
  }
};

}  // namespace fog::effects
