#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that depends on the rate. With u = W / full_scale, held at +-1 beyond it, the
/// columns are full_scale / 2^18 deg/h times Legendre polynomials of order 2 to 5, without their
/// values at rest: 3 u^2 / 2, (5 u^3 - 3 u) / 2, (35 u^4 - 30 u^2) / 8, (63 u^5 - 70 u^3 + 15 u) /
/// 8. At rest all are 0, so that a bias stays the bias; over rates up to full scale the odd ones
/// have nothing of a constant scale factor error, nor the higher of the lower.
///
/// 1 / full_scale has 42 fractional bits: at 582 deg/s it is within 2.4e-7 of itself, which moves u
/// by as much. All else rounds to 2^-28.
template <class N>
class ScaleFactorNonlinearity {
  static constexpr int kInverseFraction = 42;
  static constexpr int kScaleFraction = 28;
  static constexpr std::int32_t kDphPerDps = 3600;

 public:
  static constexpr EffectDescription description{
      "scale_factor_nonlinearity",
      18,
      "scale factor nonlinearity",
      "b = full_scale sum over i = 2..order of ei (Pi(u) - Pi(0)), u = W / full_scale within +-1, "
      "Pi Legendre's polynomials, W the input rate",
      "open loop 10 to 1000 ppm of full scale after linearisation, odd; closed loop 1 to 50 ppm, "
      "odd (modulation depth) and even (offset of the detector)",
      "order=3 full_scale=100 e2=20 e3=300",
      "one curve over the input rate: odd orders reverse with it, even ones do not; on a small "
      "range of rates the same as scale_factor (odd) and scale_factor_asymmetry (even)",
      "IEEE Std 952, scale factor nonlinearity; sine of an open loop's phase: general knowledge of "
      "the field",
      bit_of(Input::input_rate)};
  static constexpr std::array<ParameterDescription, 2> parameters{
      {{"order", "1", 2000, 5000, 3000, Scale::whole},
       {"full_scale", "deg/s", 1000, 582000, 100000, Scale::logarithmic, nullptr, nullptr,
        NotGiven::largest_input_rate}}};
  static constexpr std::array<CoefficientDescription, 4> coefficients{
      {{"e2", "ppm of full scale", kScaleFactorLog2, Multiplies::level, 1000000},
       {"e3", "ppm of full scale", kScaleFactorLog2, Multiplies::level, 1000000},
       {"e4", "ppm of full scale", kScaleFactorLog2, Multiplies::level, 1000000},
       {"e5", "ppm of full scale", kScaleFactorLog2, Multiplies::level, 1000000}}};

  static constexpr std::array<int, 3> constant_fractions{0, kInverseFraction, kScaleFraction};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    const Real full_scale_dph = given[1] * kDphPerDps;
    constants[0] = given[0];
    constants[1] = 1 / full_scale_dph;
    constants[2] = divide_by_power_of_two<kScaleFactorLog2>(full_scale_dph);
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] >= 2 && constants[0] <= 5 && constants[1] > 0 && constants[2] > 0;
  }

  explicit ScaleFactorNonlinearity(const typename N::Constant* constants)
      : order_(static_cast<std::size_t>(N::integer(constants[0]))),
        inverse_(N::template number<kInverseFraction>(constants[1])),
        scale_(N::template number<kScaleFraction>(constants[2])) {}

  std::size_t regressor_count() const { return order_ - 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const auto one = from_integer<Regressor>(1);
    const Regressor u =
        clamp(saturate_to<Regressor>(signals.block.input_rate * inverse_), -one, one);
    const Regressor square = round_to<Regressor>(u * u);
    // (63 u^4 - 70 u^2 + 15) / 16, half of what P5 is of u: the whole would leave +-8 on the way.
    const Regressor half_fifth =
        plus<15, 4>(round_to<Regressor>(square * plus<-70, 4>(times<63, 4>(square))));
    const std::array<Regressor, 4> polynomials{
        times<3, 1>(square), round_to<Regressor>(u * plus<-3, 1>(times<5, 1>(square))),
        round_to<Regressor>(square * plus<-30, 3>(times<35, 3>(square))),
        round_to<Regressor>(times<2, 0>(u) * half_fifth)};
    for (std::size_t i = 0; i + 1 < order_; ++i) {
      regressors[i] = saturate_to<Regressor>(polynomials[i] * scale_);
    }
  }

 private:
  using Regressor = typename N::Regressor;
  template <int kNumerator, int kLog2>
  static constexpr auto ratio() {
    using Integer = typename N::template Number<20>;
    return divide_by_power_of_two<kLog2>(from_integer<Integer>(kNumerator));
  }
  template <int kNumerator, int kLog2>
  static Regressor times(Regressor value) {
    return round_to<Regressor>(value * ratio<kNumerator, kLog2>());
  }
  template <int kNumerator, int kLog2>
  static Regressor plus(Regressor value) {
    return value + round_to<Regressor>(ratio<kNumerator, kLog2>());
  }

  std::size_t order_;
  typename N::template Number<kInverseFraction> inverse_;
  typename N::template Number<kScaleFraction> scale_;
};

}  // namespace fog::effects
