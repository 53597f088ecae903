#pragma once

#include "core/fixed_point/fixed.hpp"
#include "core/thermal/filtered_derivative.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

/// Thermal parameters from the model table.
template <class N>
struct ThermalParameters {
  DerivativeParameters<N> derivative;
  typename N::Temperature min{};  ///< trained range
  typename N::Temperature max{};
};

/// Block means -> Signals. The derivative uses the unclamped temperature, so the rate stays right
/// outside the trained range.
template <class N>
class ThermalState {
 public:
  explicit ThermalState(const ThermalParameters<N>& parameters)
      : min_(parameters.min), max_(parameters.max), derivative_(parameters.derivative) {}

  /// Starts as if the temperature of `block` had been constant for ever: rate 0.
  Signals<N> reset(const BlockMeans<N>& block) {
    derivative_.reset(block.temperature);
    return {clamp(block.temperature, min_, max_), {}, block};
  }

  /// Advances by one block.
  Signals<N> step(const BlockMeans<N>& block) {
    const auto rate = derivative_.step(block.temperature);
    return {clamp(block.temperature, min_, max_), rate, block};
  }

  void carry(StateCarrier& state) { derivative_.carry(state); }

 private:
  typename N::Temperature min_;
  typename N::Temperature max_;
  FilteredDerivative<N> derivative_;
};

}  // namespace fog
