#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Interference of light that couples between the polarisation axes of a birefringent path: a
/// sinusoid in temperature, with cosine and sine coefficients so that a fit is linear in both. A
/// gyro has two such paths, the pigtails of its coil, of different lengths: hence the second
/// period. Their birefringence is not linear in temperature: hence the chirp.
///
/// (T - 20 degC) / P is exact but for 1/P, which has 31 fractional bits: 110 degC away, at the end
/// of the range, an error of 2.6e-8 turns. With sine_cosine's 4.32e-9 the regressors are within
/// 1.7e-7; with a chirp of 0.2 %/degC, whose product with the temperature has as many bits, within
/// 4e-7.
template <class N>
class PolarizationRipple {
 public:
  static constexpr EffectDescription description{
      "polarization_ripple",
      7,
      "polarisation non-reciprocity, interference of cross-coupled light in one or (period2 above "
      "0)"
      " two paths",
      "b = sum over j of Acj cos(2 pi U / Pj) + Asj sin(2 pi U / Pj), U = (T - 20 degC) (1 + "
      "chirp (T - 20 degC))",
      "0.001 to 0.05 deg/h; P 26, 13, 8.7, 2.6 degC for 0.1, 0.2, 0.3, 1 m of birefringent path",
      "period=13 period2=4.8 chirp=0.05 Ac=0.02 As=-0.03 Ac2=0.005 As2=0.004",
      "periodic in temperature, not in time, with one phase heating and cooling; stops in soaks",
      "Malykin & Pozdnyakova, Opt. Spectrosc. 97, 945 (2004)"};
  static constexpr std::array<ParameterDescription, 3> parameters{
      {{"period", "degC", 2000, 60000, 13000, Scale::frequency, nullptr,
        "a polynomial in temperature"},
       {"period2", "degC", 0, 60000, 0, Scale::frequency, nullptr, "a polynomial in temperature",
        NotGiven::left_out},
       {"chirp", "%/degC", -200, 200, 0, Scale::linear, nullptr, nullptr, NotGiven::kept}}};
  static constexpr std::array<CoefficientDescription, 4> coefficients{
      {{"Ac", "deg/h", 0}, {"As", "deg/h", 0}, {"Ac2", "deg/h", 0}, {"As2", "deg/h", 0}}};

  // 1 / period of each (a second period below the minimum counts as the minimum), and the chirp,
  // 1/degC.
  static constexpr std::array<int, 3> constant_fractions{31, 31, 39};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constexpr Real kMinPeriod = 2;
    for (int i = 0; i < 2; ++i) {
      const Real period = given[i] < kMinPeriod ? kMinPeriod : given[i];
      constants[i] = given[i] > Real{} ? Real{1} / period : Real{};
    }
    constants[2] = given[2] / 100;
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] > 0 && constants[1] >= 0;
  }

  explicit PolarizationRipple(const typename N::Constant* constants)
      : turns_per_degc_{N::template number<31>(constants[0]), N::template number<31>(constants[1])},
        chirp_(N::template number<39>(constants[2])),
        two_(constants[1] > typename N::Constant{}) {}

  std::size_t regressor_count() const { return two_ ? 4 : 2; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto above = signals.temperature - from_integer<typename N::Temperature>(20);
    // At most 110 degC * 1.22.
    const auto stretched =
        round_to<Stretched>(above) + round_to<Stretched>(above * round_to<Share>(above * chirp_));
    wave(stretched * turns_per_degc_[0], regressors);
    if (two_) wave(stretched * turns_per_degc_[1], regressors + 2);
  }

 private:
  using TurnsPerDegc = typename N::template Number<31>;
  using Share = typename N::template Number<31>;
  using Stretched = typename N::template Number<23>;

  template <class Turns>
  static void wave(Turns turns, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto value = N::sine_cosine_of_turns(turns);
    regressors[0] = round_to<Regressor>(value.cosine);
    regressors[1] = round_to<Regressor>(value.sine);
  }

  std::array<TurnsPerDegc, 2> turns_per_degc_;
  typename N::template Number<39> chirp_;
  bool two_;
};

}  // namespace fog::effects
