#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Interference of light that couples between the polarisation axes of a birefringent path: a
/// sinusoid in temperature, given by its cosine and sine parts so that a fit is linear in both.
///
/// (T - 20 degC) / P is exact but for 1/P, which has 31 fractional bits: at the end of the range,
/// 110 degC away, 2.6e-8 turns. With sine_cosine's 5e-9 the regressors are within 1.7e-7.
template <class N>
class PolarizationRipple {
 public:
  static constexpr EffectDescription description{
      "polarization_ripple",
      7,
      "polarisation non-reciprocity, interference of cross-coupled light",
      "b = Ac cos(2 pi (T - 20 degC) / P) + As sin(2 pi (T - 20 degC) / P)",
      "0.001 to 0.05 deg/h; P 26, 13, 8.7, 2.6 degC for 0.1, 0.2, 0.3, 1 m of birefringent path",
      "periodic in temperature, not in time, with one phase heating and cooling; stops in soaks",
      "Malykin & Pozdnyakova, Opt. Spectrosc. 97, 945 (2004)"};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"period", "degC", 2000, 60000, 13000, false}}};
  static constexpr std::array<CoefficientDescription, 2> coefficients{
      {{"Ac", "deg/h", 0}, {"As", "deg/h", 0}}};

  static constexpr std::array<int, 1> constant_fractions{31};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constants[0] = Real{1} / given[0];
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit PolarizationRipple(const typename N::Constant* constants)
      : turns_per_degc_(N::template number<31>(constants[0])) {}

  std::size_t regressor_count() const { return 2; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto reference = from_integer<typename N::Temperature>(20);
    const auto wave = N::sine_cosine_of_turns((signals.temperature - reference) * turns_per_degc_);
    regressors[0] = round_to<Regressor>(wave.cosine);
    regressors[1] = round_to<Regressor>(wave.sine);
  }

 private:
  typename N::template Number<31> turns_per_degc_;
};

}  // namespace fog::effects
