#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Scale factor that differs between the two senses of rotation: a drift proportional to |W|, up to
/// an eighth of it. The corner at rest is rounded over the dead band d with a continuous slope: W^2
/// / 2d within it, |W| - d / 2 beyond. The regressor is that divided by 2^18 deg/h.
///
/// 1 / 2d has 33 fractional bits: a relative error of 4e-6 at d = 10 deg/s.
template <class N>
class ScaleFactorAsymmetry {
  static constexpr int kBandFraction = 10;  // as a rate has
  static constexpr int kInverseFraction = 33;
  static constexpr std::int32_t kDphPerDps = 3600;

  using Rate = typename N::Rate;

 public:
  static constexpr EffectDescription description{
      "scale_factor_asymmetry",
      19,
      "scale factor asymmetry",
      "b = a |W|, W the input rate; a W^2 / (2 dead_band) within the dead band, a (|W| - dead_band "
      "/ 2) beyond",
      "1 to 50 ppm",
      "dead_band=0.01 a=20",
      "the same sign for both senses of rotation, in proportion to the rate; with few sizes of "
      "rate "
      "the same as an even scale_factor_nonlinearity, with one size and no rest the same as bias",
      "IEEE Std 952, scale factor asymmetry",
      bit_of(Input::input_rate)};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"dead_band", "deg/s", 1, 10000, 10, Scale::logarithmic, nullptr, nullptr, NotGiven::kept}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"a", "ppm", kScaleFactorLog2, Multiplies::level, 1000000}}};

  static constexpr std::array<int, 2> constant_fractions{kBandFraction, kInverseFraction};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constants[0] = given[0] * kDphPerDps;
    constants[1] = 1 / (2 * constants[0]);
  }
  static bool constants_valid(const typename N::Constant* constants) {
    // |W| / 2d is at most 1/2 within the dead band; with constants that do not match each other it
    // must stay below 1.
    return constants[0] > 0 && constants[1] > 0 &&
           std::int64_t{constants[0]} * constants[1] <=
               3 * power_of_two<std::int64_t>(kBandFraction + kInverseFraction - 2);
  }

  explicit ScaleFactorAsymmetry(const typename N::Constant* constants)
      : dead_band_(N::template number<kBandFraction>(constants[0])),
        half_dead_band_(round_to<Rate>(divide_by_power_of_two<1>(dead_band_))),
        inverse_(N::template number<kInverseFraction>(constants[1])) {}

  std::size_t regressor_count() const { return 1; }
  void set(const Signals<N>& /*signals*/, const typename N::Coefficient* given) {
    error_ = scale_factor_error<N, 3>(given[0]);
  }
  typename N::RateDrift at(Rate rate) const { return magnitude_of(rate) * error_; }

 private:
  using Share = typename N::template Number<31>;

  // The lowest value of the format has no negative.
  static Rate absolute(Rate rate) {
    return rate < Rate{} ? N::saturating_difference({}, rate) : rate;
  }
  Rate magnitude_of(Rate rate) const {
    const Rate magnitude = absolute(rate);
    if (magnitude < dead_band_) {
      return round_to<Rate>(magnitude * round_to<Share>(magnitude * inverse_));
    }
    return magnitude - half_dead_band_;
  }

  Rate dead_band_;
  Rate half_dead_band_;
  typename N::template Number<kInverseFraction> inverse_;
  typename N::ScaleFactorError error_{};
};

}  // namespace fog::effects
