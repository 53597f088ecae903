#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog {

/// No chamber heats a coil faster: a higher rate is a fault of the sensor.
constexpr std::int32_t kMaxRateDegcPerMin = 32;

/// Time constant of a FilteredDerivative, per block.
template <class N>
struct DerivativeParameters {
  typename FirstOrderLag<N>::Decay decay{};     ///< of both lags
  typename N::template Number<24> rate_gain{};  ///< decay * blocks per minute
};

/// Derivative of a temperature, degC/min, after two equal first-order lags. Without them a
/// resolution of 0.0625 degC, differenced over 10 s, would be 0.4 degC/min of noise; one lag alone
/// would still jump by step/tau at every step of the sensor. In a steady ramp the derivative is
/// exact, with a delay of two time constants.
template <class N>
class FilteredDerivative {
 public:
  using Temperature = typename N::Temperature;
  using TemperatureRate = typename N::TemperatureRate;

  explicit FilteredDerivative(const DerivativeParameters<N>& parameters)
      : rate_gain_(parameters.rate_gain), first_(parameters.decay), second_(parameters.decay) {}

  /// Starts as if `temperature` had been constant for ever: rate 0.
  void reset(Temperature temperature) {
    first_.reset(round_to<State>(temperature));
    second_.reset(round_to<State>(temperature));
  }

  /// Advances by one block with mean temperature `temperature`.
  TemperatureRate step(Temperature temperature) {
    first_.step(round_to<State>(temperature));
    // Change of the second lag in this block, before its decay. Rounded to 2^-27 degC (1.5e-8
    // degC/min at 30 s), clipped at +-32 degC, which clips no rate for time constants up to 60 s.
    const auto ahead =
        saturate_to<typename N::template Number<26>>(first_.value() - second_.value());
    second_.step(first_.value());
    const auto rate = saturate_to<TemperatureRate>(ahead * rate_gain_);
    constexpr auto kMax = from_integer<TemperatureRate>(kMaxRateDegcPerMin);
    return clamp(rate, -kMax, kMax);
  }

  void carry(StateCarrier& state) {
    first_.carry(state);
    second_.carry(state);
  }

 private:
  using State = typename FirstOrderLag<N>::State;

  typename N::template Number<24> rate_gain_;
  FirstOrderLag<N> first_;
  FirstOrderLag<N> second_;
};

}  // namespace fog
