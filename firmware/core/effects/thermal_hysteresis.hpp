#pragma once

#include <array>
#include <cstddef>

#include "core/effects/effect.hpp"
#include "core/thermal/play.hpp"

namespace fog::effects {

/// Thermal hysteresis after Prandtl and Ishlinskii: one or two play operators on the temperature.
/// The regressor is (T - play) / radius: +1 on the warming branch, -1 on the cooling one. So the
/// coefficient is half the width of the loop, and single-valued functions of T are left to
/// bias_temperature.
///
/// After power-on the branch is unknown. The operators start centred; the first excursion of twice
/// the radius makes them right. Until then the error is up to |h| and the status has
/// history_unknown, and so it has after a gap, over which the branch is kept.
template <class N>
class ThermalHysteresis {
 public:
  static constexpr EffectDescription description{
      "thermal_hysteresis",
      8,
      "thermal hysteresis, one or (radius2 above 0) two play operators of Prandtl-Ishlinskii",
      "b = sum over j of hj (T - play_rj[T]) / rj",
      "loop width 2h 0.005 to 0.1 deg/h, r 2 to 20 degC",
      "radius=3 radius2=10 h1=0.03 h2=0.02",
      "loop in b over T that stays at constant T, whatever the ramp rate; the branch depends on the"
      " last turning point",
      "play operators: Prandtl-Ishlinskii; loops measured in FOG scale factors (GSA-LSTM, 2024)"};
  static constexpr std::array<ParameterDescription, 2> parameters{
      {{"radius", "degC", 500, 40000, 5000, Scale::logarithmic, nullptr, "a line in temperature"},
       {"radius2", "degC", 0, 40000, 0, Scale::logarithmic, nullptr, "a line in temperature",
        NotGiven::left_out}}};
  static constexpr std::array<CoefficientDescription, 2> coefficients{
      {{"h1", "deg/h", 0}, {"h2", "deg/h", 0}}};

  // Radius and its reciprocal, of each operator. A radius below half a degree counts as half a
  // degree: so small a hysteresis is the sensor's, not the coil's.
  static constexpr std::array<int, 4> constant_fractions{22, 29, 22, 29};
  template <class Real>
  static void board_constants(const Real* given, Real /*block_s*/, Real* constants) {
    constexpr Real kMinRadius = Real{1} / 2;
    for (std::size_t i = 0; i < 2; ++i) {
      const bool used = given[i] > Real{};
      const Real radius = given[i] < kMinRadius ? kMinRadius : given[i];
      constants[2 * i] = used ? radius : Real{};
      constants[2 * i + 1] = used ? Real{1} / radius : Real{};
    }
  }
  // |T| <= 130 degC and radii below 256 degC stay within the operator's +-512.
  static bool constants_valid(const typename N::Constant* constants) {
    constexpr typename N::Constant kMaxRadius = 256 << 22;
    return constants[0] > 0 && constants[0] < kMaxRadius && constants[2] >= 0 &&
           constants[2] < kMaxRadius;
  }

  explicit ThermalHysteresis(const typename N::Constant* constants)
      : first_(N::template number<22>(constants[0])),
        second_(N::template number<22>(constants[2])),
        per_radius_{N::template number<29>(constants[1]), N::template number<29>(constants[3])},
        two_(constants[2] > typename N::Constant{}) {}

  std::size_t regressor_count() const { return two_ ? 2 : 1; }
  void reset(const Signals<N>& signals) {
    first_.start(operand(signals));
    second_.start(operand(signals));
  }
  bool history_known() const { return first_.history_known() && second_.history_known(); }
  void forget_history() {
    first_.forget_history();
    if (two_) second_.forget_history();  // else it makes no step to learn it in
  }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    using Regressor = typename N::Regressor;
    const auto x = operand(signals);
    regressors[0] = saturate_to<Regressor>(first_.step(x) * per_radius_[0]);
    if (two_) regressors[1] = saturate_to<Regressor>(second_.step(x) * per_radius_[1]);
  }

  void carry(StateCarrier& state) {
    first_.carry(state);
    second_.carry(state);
  }

 private:
  using Value = typename Play<N>::Value;
  static Value operand(const Signals<N>& signals) { return round_to<Value>(signals.temperature); }

  Play<N> first_;
  Play<N> second_;
  std::array<typename N::template Number<29>, 2> per_radius_;
  bool two_;
};

}  // namespace fog::effects
