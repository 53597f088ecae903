#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Decay after power-on: self-heating of source and electronics. A function of the time since
/// power-on, not a state: no error accumulates, and a restart of the thermal state does not repeat
/// the warm-up.
///
/// A board cannot know how long the power was off: it takes every start for a cold one, and its
/// history for unknown until five time constants later. A recording
/// that goes on after a restart tells it; then what has cooled meanwhile warms up again.
///
/// tau is at most 5 h. Slower decays are those of the housing's temperature, which the sensor
/// measures, and would be confused with ageing.
///
/// blocks / tau has 31 fractional bits: a relative error of 6.3e-6 at the longest tau, which
/// changes the exponential by at most 2.3e-6. A tau shorter than a block counts as one block.
template <class N>
class WarmUp {
 public:
  static constexpr EffectDescription description{
      "warm_up",
      11,
      "warm-up after power-on",
      "b = A (1 - w) exp(-t / tau), t since power-on, w what is left of the warmth before it: "
      "0 on a board",
      "A 0.01 to 0.5 deg/h, tau 5 to 30 min",
      "tau=1200 A=0.3",
      "locked to power-on, not to temperature; the same after every cold restart",
      "IEEE Std 952, warm-up time; sizes are general knowledge of the field",
      bit_of(Input::elapsed)};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"tau", "s", 10000, 18000000, 1200000, Scale::logarithmic, nullptr, "a line in time"}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"A", "deg/h", 0}}};

  static constexpr std::array<int, 1> constant_fractions{31};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = N::share(block_s / given[0]);
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit WarmUp(const typename N::Constant* constants)
      : per_tau_(N::template number<31>(constants[0])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  bool history_known() const { return has_settled_; }
  void forget_history() {}  // it follows from the time
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Exponent = typename N::template Number<26>;  // clips at 32; exp(-32) is 0
    const auto exponent = saturate_to<Exponent>(signals.block.since_power_on() * per_tau_);
    has_settled_ = exponent >= from_integer<Exponent>(5);
    regressors[0] = round_to<typename N::Regressor>(
        N::from_cold(signals.block.power_on, per_tau_, N::exponential_decay(exponent)));
  }

 private:
  typename N::template Number<31> per_tau_;
  bool has_settled_ = false;
};

}  // namespace fog::effects
