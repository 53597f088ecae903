#pragma once

#include <array>

#include "core/effects/effect.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog::effects {

/// Rate term of a coil that follows its sensor late: dT/dt through a further first-order lag. Lag
/// and derivative commute, so the state is the lagged rate itself.
///
/// State: bounded by |rate| <= 32 degC/min, as a lag never leaves the range of its input. It rests
/// where |rate - state| < 2^-23 degC/min (FirstOrderLag), so it neither drifts nor rings.
template <class N>
class ThermalLag {
 public:
  static constexpr EffectDescription description{
      "thermal_lag",
      4,
      "rate term of a coil that lags behind the temperature sensor",
      "b = K dTc/dt, tau dTc/dt = T - Tc",
      "K 0.05 to 0.3 deg/h per (degC/min); tau 45 s for a bare coil, 5 min with spool, 16 min with "
      "housing, 1.5 h on a stone base",
      "tau=960 K=0.14",
      "exponential tail of the rate term after a ramp ends, slow growth after it starts",
      "time constants computed with a finite-volume model of coil, spool and housing"};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"tau", "s", 5000, 20000000, 300000, Scale::logarithmic, "temperature_rate",
        "a line in temperature", NotGiven::identified, Time::constant_of_rate}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"K", "deg/h per (degC/min)", 2, Multiplies::temperature_rate}}};

  static constexpr std::array<int, 1> constant_fractions{31};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = N::decay(block_s / given[0]);
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit ThermalLag(const typename N::Constant* constants)
      : lag_(N::template number<31>(constants[0])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& signals) { lag_.reset(in_state(signals)); }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    regressors[0] =
        saturate_to<typename N::Regressor>(divide_by_power_of_two<2>(lag_.step(in_state(signals))));
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
