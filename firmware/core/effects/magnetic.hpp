#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Faraday effect of a field in the coil's plane on a twisted fibre, and its temperature
/// coefficient. Regressors B / 256 uT and B / 256 uT (T - 20 degC) / 64 degC: the first is exact,
/// both clip at 2 mT or beyond, forty times the Earth's field.
template <class N>
class Magnetic : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "magnetic",
      13,
      "Faraday effect",
      "b = m B + n B (T - 20 degC), B the field",
      "in the Earth's field 0.2 to 0.3 deg/h unshielded, 0.03 shielded; n 5e-6 deg/h/uT/degC (PM "
      "fibre)",
      "m=0.005 n=5e-6",
      "cosine over azimuth; in one position the same as bias and bias_temperature",
      "IEEE Trans. Instrum. Meas. 2022, transverse magneto-optic error; IEEE Access 8, 222242 "
      "(2020)",
      bit_of(Input::magnetic)};
  static constexpr std::array<CoefficientDescription, 2> coefficients{
      {{"m", "deg/h/uT", 8}, {"n", "deg/h/uT/degC", 14}}};

  explicit Magnetic(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 2; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto reference = from_integer<typename N::Temperature>(20);
    const auto field = signals.block[Input::magnetic];
    regressors[0] = saturate_to<Regressor>(divide_by_power_of_two<8>(field));
    regressors[1] = saturate_to<Regressor>(
        divide_by_power_of_two<14>(field * (signals.temperature - reference)));
  }
};

}  // namespace fog::effects
