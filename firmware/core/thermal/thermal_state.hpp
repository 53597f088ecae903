#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

/// Numbers that the thermal stage takes from the model table.
template <class N>
struct ThermalParameters {
  typename FirstOrderLag<N>::Decay smoothing_decay{};   ///< per block, of both derivative stages
  typename N::template Number<20> blocks_per_minute{};  ///< turns a change per block into degC/min
  typename N::Temperature least{};                      ///< trained range
  typename N::Temperature most{};
};

/// Faster than any chamber heats a coil: what is beyond comes from a sensor, not from the coil.
constexpr std::int32_t kMostRateDegcPerMin = 32;

/// Block means of the temperature -> Signals.
///
/// The derivative is that of the temperature after two equal first-order lags: a sensor resolution
/// of 0.0625 degC differenced at 10 s would be 0.4 degC/min of noise. Two stages, because one alone
/// still jumps by step/tau at every step of the sensor. In a steady ramp the derivative is exact;
/// it is late by two time constants. Before the derivative, temperature is not clamped: the rate
/// stays right outside the trained range.
template <class N>
class ThermalState {
 public:
  using Temperature = typename N::Temperature;

  explicit ThermalState(const ThermalParameters<N>& parameters)
      : parameters_(parameters),
        first_(parameters.smoothing_decay),
        second_(parameters.smoothing_decay) {}

  /// Starts as if the temperature had been this one for ever: rate 0.
  Signals<N> reset(Temperature temperature) {
    first_.reset(round_to<State>(temperature));
    second_.reset(round_to<State>(temperature));
    return signals(temperature, typename N::TemperatureRate{});
  }

  /// Advances by one block whose mean temperature is given.
  Signals<N> step(Temperature temperature) {
    const State before = second_.value();
    second_.step(first_.step(round_to<State>(temperature)));
    // Change per block: clipped at +-128 degC, rounded to 2^-25 degC (2e-6 degC/min at 1 s).
    const auto change = saturate_to<typename N::template Number<24>>(second_.value() - before);
    const auto rate =
        saturate_to<typename N::TemperatureRate>(change * parameters_.blocks_per_minute);
    constexpr auto kMost = from_integer<typename N::TemperatureRate>(kMostRateDegcPerMin);
    return signals(temperature, clamp(rate, -kMost, kMost));
  }

 private:
  using State = typename FirstOrderLag<N>::State;

  Signals<N> signals(Temperature temperature, typename N::TemperatureRate rate) const {
    return {clamp(temperature, parameters_.least, parameters_.most), rate};
  }

  ThermalParameters<N> parameters_;
  FirstOrderLag<N> first_;
  FirstOrderLag<N> second_;
};

}  // namespace fog
