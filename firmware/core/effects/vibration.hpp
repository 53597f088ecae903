#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Vibration rectification: vibration modulates power and phase together, and their product has a
/// non-zero mean. The regressor is (g / 16)^2; it clips at 45 g rms.
template <class N>
class Vibration : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "vibration",
      14,
      "vibration rectification",
      "b = k g^2, g the vibration's rms",
      "0.001 deg/h/g^2 (0.0445 deg/h at 6 g) before, a quarter after gain monitoring",
      "k=0.00125",
      "appears and stops with vibration: a chamber's fan or compressor; the noise rises with it",
      "Qin et al. (2026); gain-monitoring vibration compensation (Beihang)",
      bit_of(Input::vibration)};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"k", "deg/h/g^2", 8}}};

  explicit Vibration(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto g = signals.block[Input::vibration];
    regressors[0] = saturate_to<typename N::Regressor>(divide_by_power_of_two<8>(g * g));
  }
};

}  // namespace fog::effects
