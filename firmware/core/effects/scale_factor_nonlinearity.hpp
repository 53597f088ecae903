#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that depends on the rate. With u = W / full_scale, clipped to +-1, the regressors
/// are full_scale / 2^18 deg/h times the Legendre polynomials of order 2 to 5 without their values
/// at rest: 3 u^2 / 2, (5 u^3 - 3 u) / 2, (35 u^4 - 30 u^2) / 8, (63 u^5 - 70 u^3 + 15 u) / 8. All
/// are 0 at rest, so they do not change the bias. Over rates up to full scale the odd ones are
/// orthogonal to a constant scale factor error and to each other.
///
/// Each contains a factor u: together they are W, up to full scale, times one polynomial of order 4
/// in u, which is a scale factor error. Its coefficients are summed once per block, to 2^-35, and
/// clipped to 3/256 (for e5 alone: 1340 ppm), so that the sum of the five is within +-1/16. Each of
/// the four steps of Horner's rule is rounded down to 2^-34: 5e-5 deg/h at 100 deg/s.
template <class N>
class ScaleFactorNonlinearity {
  static constexpr int kFullScaleFraction = 10;  // as a rate has
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

  static constexpr std::array<int, 2> constant_fractions{0, kFullScaleFraction};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constants[0] = given[0];
    constants[1] = given[1] * kDphPerDps;
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] >= 2 && constants[0] <= 5 && constants[1] > 0;
  }

  explicit ScaleFactorNonlinearity(const typename N::Constant* constants)
      : order_(static_cast<std::size_t>(N::integer(constants[0]))),
        full_scale_(N::template number<kFullScaleFraction>(constants[1])),
        share_of_full_scale_(full_scale_) {}

  std::size_t regressor_count() const { return order_ - 1; }
  void set(const Signals<N>& /*signals*/, const typename N::Coefficient* given) {
    std::array<Column, 4> e{};
    for (std::size_t i = 0; i + 1 < order_; ++i) {
      e[i] = saturate_to<Column>(divide_by_power_of_two<kScaleFactorLog2>(given[i]));
    }
    powers_ = {sixteenths(times<-24>(e[1]) + times<30>(e[3])),
               sixteenths(times<24>(e[0]) + times<-60>(e[2])),
               sixteenths(times<40>(e[1]) + times<-140>(e[3])), sixteenths(times<70>(e[2])),
               sixteenths(times<126>(e[3]))};
  }
  [[gnu::always_inline]] typename N::RateDrift at(typename N::Rate rate) const {
    const typename N::Rate within = clamp(rate, -full_scale_, full_scale_);
    const auto u = share_of_full_scale_(within);
    const auto step = [&](Power higher, Power own) {
      return own + round_to<Power>(high_product(higher, u));
    };
    // Unrolled: a loop would cost ten instructions.
    const Power sum =
        step(step(step(step(powers_[4], powers_[3]), powers_[2]), powers_[1]), powers_[0]);
    return within * round_to<typename N::ScaleFactorError>(sum);
  }

 private:
  using Column = typename N::template Number<36>;
  using Power = typename N::template Number<35>;
  template <int kFactor>
  static auto times(Column column) {
    return column * from_integer<typename N::template Number<0>>(kFactor);
  }
  template <class Sum>
  static Power sixteenths(Sum sum) {
    const auto max = round_to<Power>(
        divide_by_power_of_two<8>(from_integer<typename N::template Number<20>>(3)));
    return clamp(saturate_to<Power>(divide_by_power_of_two<4>(sum)), -max, max);
  }

  std::size_t order_;
  typename N::Rate full_scale_;
  typename N::ShareOf share_of_full_scale_;
  std::array<Power, 5> powers_{};  // coefficients of u^0, u^1, ...
};

}  // namespace fog::effects
