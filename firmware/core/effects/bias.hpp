#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Constant bias at the reference temperature.
template <class N>
class Bias : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "bias",
      0,
      "static bias",
      "b = b0",
      "0.01 to 1 deg/h",
      "b0=0.72",
      "residual has a mean that nothing changes",
      "IEEE Std 528, bias (drift rate), acceleration-insensitive"};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"b0", "deg/h", 0}}};

  explicit Bias(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& /*signals*/, typename N::Regressor* regressors) {
    regressors[0] = from_integer<typename N::Regressor>(1);
  }
};

}  // namespace fog::effects
