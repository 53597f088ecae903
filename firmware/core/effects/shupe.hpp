#pragma once

#include <array>

#include "core/effects/effect.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog::effects {

/// Pure Shupe effect: rate of change of the gradient through the winding. The inside of the coil
/// follows the sensor with a first-order lag, so d(T - Tc)/dt is dT/dt less the lagged dT/dt.
///
/// State: bounded and free of drift, as in ThermalLag. The regressor is the difference / (8
/// degC/min): two rates within +-32 degC/min differ by at most 64. With equal tau, temperature_rate
/// = shupe + thermal_lag: a fit can have two of the three.
template <class N>
class Shupe {
 public:
  static constexpr EffectDescription description{
      "shupe",
      3,
      "Shupe effect, transient gradient through the winding",
      "b = K d(T - Tc)/dt, tau dTc/dt = T - Tc",
      "K 0.14 deg/h per (degC/min) for an ideal quadrupolar winding, 3 for a dipolar one, 0.9 more "
      "per metre of asymmetry",
      "tau=120 K=1",
      "spike where a ramp starts, opposite spike where it ends, zero in between and in soaks",
      "Shupe, Appl. Opt. 19, 654 (1980); Frigo, Proc. SPIE 412, 268 (1983); IEEE Std 952, "
      "D_gradTdot"};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"tau", "s", 5000, 20000000, 120000, Scale::logarithmic, nullptr, "temperature_rate",
        NotGiven::identified, Time::constant_of_rate}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"K", "deg/h per (degC/min)", 3, Multiplies::temperature_rate}}};

  static constexpr std::array<int, 1> constant_fractions{31};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = N::decay(block_s / given[0]);
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit Shupe(const typename N::Constant* constants)
      : lag_(N::template number<31>(constants[0])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& signals) { lag_.reset(in_state(signals)); }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const State rate = in_state(signals);
    regressors[0] =
        saturate_to<typename N::Regressor>(divide_by_power_of_two<3>(rate - lag_.step(rate)));
  }

  void carry(StateCarrier& state) { lag_.carry(state); }

 private:
  using State = typename FirstOrderLag<N>::State;
  static State in_state(const Signals<N>& signals) {
    return round_to<State>(signals.temperature_rate);
  }

  FirstOrderLag<N> lag_;
};

}  // namespace fog::effects
