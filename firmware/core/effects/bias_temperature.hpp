#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// Bias as a polynomial in temperature, without its constant term (that is `bias`).
///
/// With x = (T - 20 degC) / 64 K the regressors are x, x^2 ... x^order. Trained ranges lie within
/// -60 to +100 degC, so |x| <= 1.25 and x^9 <= 7.5 fits +-8; outside it powers clip. x itself is
/// exact, each further power rounds once: the error of x^k is below k * 1.25^(k-1) * 2^-29.
template <class N>
class BiasTemperature {
 public:
  static constexpr EffectDescription description{
      "bias_temperature",
      1,
      "bias temperature sensitivity, static polynomial",
      "b = sum over k = 1..order of bk (T - 20 degC)^k",
      "b1 1e-4 to 1e-3 deg/h/degC, b2 1e-6 to 5e-5 deg/h/degC^2; 0.02 to 0.2 deg/h over the range",
      "order=3 b1=-3.5e-4 b2=-3.2e-5 b3=1e-7",
      "residual is one curve over temperature, the same heating and cooling, and stays in soaks",
      "IEEE Std 952, D_T"};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"order", "1", 1000, 9000, 2000, Scale::whole}}};
  static constexpr std::array<CoefficientDescription, 9> coefficients{{{"b1", "deg/h/degC", 6},
                                                                       {"b2", "deg/h/degC^2", 12},
                                                                       {"b3", "deg/h/degC^3", 18},
                                                                       {"b4", "deg/h/degC^4", 24},
                                                                       {"b5", "deg/h/degC^5", 30},
                                                                       {"b6", "deg/h/degC^6", 36},
                                                                       {"b7", "deg/h/degC^7", 42},
                                                                       {"b8", "deg/h/degC^8", 48},
                                                                       {"b9", "deg/h/degC^9", 54}}};

  static constexpr std::array<int, 1> constant_fractions{0};
  template <class Real>
  static void board_constants(const Real* parameters_given, Real /*block_s*/, Real* constants) {
    constants[0] = parameters_given[0];
  }
  static bool constants_valid(const typename N::Constant* constants) {
    return constants[0] >= 1 && constants[0] <= 9;
  }

  explicit BiasTemperature(const typename N::Constant* constants)
      : order_(static_cast<std::size_t>(N::integer(constants[0]))) {}

  std::size_t regressor_count() const { return order_; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto reference = from_integer<typename N::Temperature>(20);
    const auto x =
        saturate_to<Regressor>(divide_by_power_of_two<6>(signals.temperature - reference));
    Regressor power = x;
    for (std::size_t k = 0; k < order_; ++k) {
      regressors[k] = power;
      power = saturate_to<Regressor>(power * x);
    }
  }

 private:
  std::size_t order_;
};

}  // namespace fog::effects
