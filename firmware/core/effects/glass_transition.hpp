#pragma once

#include <array>

#include "core/effects/effect.hpp"
#include "core/thermal/first_order_lag.hpp"

namespace fog::effects {

/// Glass transition of adhesive, potting or coating: below Tg it is stiff, which shifts the bias
/// and adds to the rate term. The glassy share s((Tg - T) / w) is the logistic function, within
/// 2.51e-9. 1/w has 29 fractional bits and Tg has 22, which changes the share by less than 1e-7. It
/// freezes late, because the structure takes its time to relax: a lag of the share.
template <class N>
class GlassTransition {
 public:
  static constexpr EffectDescription description{
      "glass_transition",
      9,
      "glass transition of adhesive, potting or coating",
      "b = (A + G dT/dt) f, f behind s((Tg - T) / w) by the lag, s(x) = 1 / (1 + exp(-x))",
      "A 0.01 to 0.3 deg/h, G 0.3 to 3 times the rate term's K, Tg -60 to 60 degC, w 2 to 8 degC; "
      "lag 100 s (by the definition of Tg) to 20 min",
      "tg=-20 width=4 lag=180 A=0.1 G=0.14",
      "step of the bias at one temperature in both directions; another ratio of bias to rate below",
      "US5546482 Cordova & Surabian (1996); Acta Armamentarii 42(6) 1223 (2021)"};
  static constexpr std::array<ParameterDescription, 3> parameters{
      {{"tg", "degC", -60000, 80000, -20000, Scale::place, "a polynomial in temperature",
        "a polynomial in temperature"},
       {"width", "degC", 500, 8000, 4000, Scale::linear},
       {"lag", "s", 0, 3600000, 0, Scale::linear, "no lag", nullptr, NotGiven::kept,
        Time::constant}}};
  static constexpr std::array<CoefficientDescription, 2> coefficients{
      {{"A", "deg/h", 0}, {"G", "deg/h per (degC/min)", 2, Multiplies::temperature_rate}}};

  // The decay per block is 0 without a lag.
  static constexpr std::array<int, 3> constant_fractions{22, 29, 31};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = given[0];
    constants[1] = Real{1} / given[1];
    constants[2] = given[2] > 0 ? N::decay(block_s / given[2]) : Real{0};
  }
  // |Tg| < 256 degC and |T| <= 130 degC: the difference stays within +-512.
  static bool constants_valid(const typename N::Constant* constants) {
    constexpr typename N::Constant kMax = 256 << 22;
    return constants[0] > -kMax && constants[0] < kMax && constants[1] > 0 && constants[2] >= 0;
  }

  explicit GlassTransition(const typename N::Constant* constants)
      : tg_(N::template number<22>(constants[0])),
        per_width_(N::template number<29>(constants[1])),
        has_lag_(constants[2] > 0),
        frozen_(N::template number<31>(constants[2])) {}

  std::size_t regressor_count() const { return 2; }
  void reset(const Signals<N>& signals) { frozen_.reset(round_to<State>(glassy(signals))); }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    Share share = glassy(signals);
    if (has_lag_) share = round_to<Share>(frozen_.step(round_to<State>(share)));
    regressors[0] = round_to<Regressor>(share);
    regressors[1] =
        saturate_to<Regressor>(divide_by_power_of_two<2>(share * signals.temperature_rate));
  }

  void carry(StateCarrier& state) { frozen_.carry(state); }

 private:
  using State = typename FirstOrderLag<N>::State;
  using Share = typename N::template Number<30>;

  Share glassy(const Signals<N>& signals) const {
    using Argument = typename N::template Number<27>;
    const auto below = tg_ - round_to<typename N::template Number<22>>(signals.temperature);
    return N::logistic(saturate_to<Argument>(below * per_width_));
  }

  typename N::template Number<22> tg_;
  typename N::template Number<29> per_width_;
  bool has_lag_;
  FirstOrderLag<N> frozen_;
};

}  // namespace fog::effects
