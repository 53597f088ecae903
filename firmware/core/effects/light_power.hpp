#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Relative change of light power: the less light, the more a fixed electronic offset matters. Its
/// form is ln P; (P - P0) / P0 and P0 / P - 1 are both its first-order form. The nominal power P0
/// then only shifts the bias, so it need not be known or fitted. The regressor is ln(P / 100 uW) /
/// 2, within 1e-8, from -7.9 to 2.9; no light counts as 2^-16 uW, the LSB.
template <class N>
class LightPower : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "light_power",
      15,
      "light power: electronic offset against signal",
      "b = k ln(P / 100 uW), for small changes k (P - P0) / P0",
      "k 0.01 to 0.5 deg/h",
      "k=0.1",
      "follows the light power monitor: ageing source, bent fibre, shut-down of the waveguide",
      "Ponomarev et al., Appl. Sci. 9, 4585 (2019); 11, 9853 (2021)",
      bit_of(Input::light_power)};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"k", "deg/h", 1}}};

  explicit LightPower(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Power = typename N::template Wide<16>;
    const auto min = divide_by_power_of_two<16>(from_integer<typename N::Elapsed>(1));
    const auto power = signals.block[Input::light_power];
    const auto logarithm = N::natural_logarithm(round_to<Power>(power < min ? min : power)) -
                           N::natural_logarithm(from_integer<Power>(100));
    regressors[0] = saturate_to<typename N::Regressor>(divide_by_power_of_two<1>(logarithm));
  }
};

}  // namespace fog::effects
