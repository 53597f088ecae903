#pragma once

#include <array>

#include "core/effects/effect.hpp"
#include "core/thermal/filtered_derivative.hpp"

namespace fog::effects {

/// Gradient along the coil's axis, D = T2 - T, from a second sensor. Regressors: its rate of change
/// (which a quadrupolar winding cancels only to first order) and D itself (strain of the clamped
/// ends).
///
/// D is the difference of the measured block means, not clamped to the trained range. It saturates
/// at 32768 degC, as a table may let the second sensor read anything. Its derivative has two lags,
/// like every derivative here, with its own time constant.
template <class N>
class AxialGradient {
 public:
  static constexpr EffectDescription description{
      "axial_gradient",
      6,
      "axial gradient between two temperature sensors",
      "b = K dD/dt + S D, D = T2 - T",
      "0.01 to 0.06 deg/h transient and 0.05 to 0.13 deg/h static for 1 W on the spool",
      "tau=30 K=0.9 S=0.1",
      "error while the coil sensor hardly moves; follows heater or electronics load, or mounting",
      "Zhuo & Du, Shupe effect in a multidimensional thermal field; Sensors 16(6) 900 (2016)",
      bit_of(Input::temperature2)};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"tau", "s", 5000, 600000, 30000, Scale::logarithmic, nullptr, nullptr, NotGiven::identified,
        Time::constant_of_rate}}};
  static constexpr std::array<CoefficientDescription, 2> coefficients{
      {{"K", "deg/h per (degC/min)", 2, Multiplies::temperature_rate}, {"S", "deg/h/degC", 5}}};

  static constexpr std::array<int, 2> constant_fractions{31, 24};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = N::decay(block_s / given[0]);
    constants[1] = constants[0] * 60 / block_s;
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] > 0 && constants[1] > 0;
  }

  explicit AxialGradient(const typename N::Constant* constants)
      : derivative_({N::template number<31>(constants[0]), N::template number<24>(constants[1])}) {}

  std::size_t regressor_count() const { return 2; }
  void reset(const Signals<N>& signals) { derivative_.reset(difference(signals)); }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto along = difference(signals);
    regressors[0] = saturate_to<Regressor>(divide_by_power_of_two<2>(derivative_.step(along)));
    regressors[1] = saturate_to<Regressor>(divide_by_power_of_two<5>(along));
  }

  void carry(StateCarrier& state) { derivative_.carry(state); }

 private:
  static typename N::Temperature difference(const Signals<N>& signals) {
    const typename N::Temperature second = signals.block[Input::temperature2];
    return N::saturating_difference(second, signals.block.temperature);
  }

  FilteredDerivative<N> derivative_;
};

}  // namespace fog::effects
