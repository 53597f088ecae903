#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that follows the source's wavelength and the coil's size: an error in proportion to
/// the rate. The regressor is W (T - 20 degC) / 2^25 deg/h degC: 570 deg/s at 110 degC distance
/// make 6.7. One LSB of it, 0.125 deg/h degC, is 4e-5 deg/h at 300 ppm/degC.
///
/// On the board W is the block mean of the compensated rate, a block old when it counts: right for
/// what is steady over seconds (Earth rate, a rate table's dwell), late by a block for the rest.
template <class N>
class ScaleFactorTemperature : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "scale_factor_temperature",
      10,
      "scale factor: source wavelength and coil size",
      "b = k W (T - 20 degC), W the input rate",
      "k 1 to 10 ppm/degC (erbium), 200 to 400 ppm/degC (SLD without cooler), coil 2 to 10 "
      "ppm/degC",
      "k=300",
      "in proportion to the input rate and reversed with it; in one static position the same as "
      "bias_temperature",
      "US8254416; IEEE Std 952, scale factor temperature sensitivity",
      bit_of(Input::input_rate)};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"k", "ppm/degC", 25, Multiplies::level, 1000000}}};

  explicit ScaleFactorTemperature(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto reference = from_integer<typename N::Temperature>(20);
    regressors[0] = saturate_to<typename N::Regressor>(
        divide_by_power_of_two<25>((signals.temperature - reference) * signals.block.input_rate));
  }
};

}  // namespace fog::effects
