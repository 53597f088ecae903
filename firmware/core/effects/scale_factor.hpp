#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Constant scale factor error, up to half of the rate. The regressor is W / 2^18 deg/h.
template <class N>
class ScaleFactor : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "scale_factor",
      17,
      "scale factor error, constant",
      "b = e W, W the input rate",
      "10 to 1000 ppm: what a calibration at one temperature left, or a reference with a wrong "
      "scale",
      "e=300",
      "in proportion to the input rate, the same at every temperature; in one position the same as "
      "bias",
      "IEEE Std 952, scale factor error",
      bit_of(Input::input_rate)};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"e", "ppm", kScaleFactorLog2, Multiplies::level, 1000000}}};

  explicit ScaleFactor(const typename N::Constant* /*constants*/) {}

  std::size_t regressor_count() const { return 1; }
  void set(const Signals<N>& /*signals*/, const typename N::Coefficient* given) {
    error_ = scale_factor_error<N, 1>(given[0]);
  }
  typename N::RateDrift at(typename N::Rate rate) const { return rate * error_; }

 private:
  typename N::ScaleFactorError error_{};
};

}  // namespace fog::effects
