#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Jump of the bias at one time of one recording: mode hop, stick-slip. In a fit it keeps the jump
/// out of the other effects; it predicts nothing for the next recording.
template <class N>
class BiasStep {
 public:
  static constexpr EffectDescription description{
      "bias_step",
      16,
      "intermittent step: mode hop, stick-slip",
      "b = A for t >= at, t since power-on",
      "0.02 to 0.5 deg/h",
      "at=30000 A=0.1",
      "change point that repeats neither in time nor in temperature; with a drop of light power it "
      "is light_power",
      "general knowledge of the field; a jump at 20 to -40 degC in the reference paper",
      bit_of(Input::elapsed),
      "it is an event of one recording, and no board can know when the next one comes",
      true};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"at", "s", 0, 2000000000, 0, Scale::linear}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{{{"A", "deg/h", 0}}};

  static constexpr std::array<int, 1> constant_fractions{0};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = given[0] / block_s;
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] >= 0; }

  explicit BiasStep(const typename N::Constant* constants)
      : at_(N::template number<0>(constants[0])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    regressors[0] = from_integer<typename N::Regressor>(signals.block.elapsed >= at_ ? 1 : 0);
  }

 private:
  typename N::Elapsed at_;
};

}  // namespace fog::effects
