#pragma once

#include <array>
#include <type_traits>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// The clock of the recorded input rate is late: the record at time t shows the rotation at t -
/// delay. This is a fault of the recording; a fit uses the effect to keep it out of the scale
/// factor's coefficients.
///
/// The regressor is the mean of dW/dt / 2^19 deg/h/s over the present block: the rise of W from the
/// block's beginning to its end, which only a recording tells, by its duration. A shift by `delay`
/// is that to first order; to second order, which 0.1 s in a sweep of a minute makes 0.5 % of it,
/// half of `near` times the mean of d2W/dt2 is added, so that `near` and `delay` come out alike.
template <class N>
class LateReference {
 public:
  static constexpr EffectDescription description{
      "late_reference",
      20,
      "clock of the input rate's record behind the gyro's",
      "b = delay (dW/dt + near/2 d2W/dt2), W the input rate; near is left at 0",
      "1 to 100 ms, negative where the gyro's clock is behind",
      "delay=20",
      "where the input rate changes: in sweeps, with 90 degrees of phase; in steps at their flanks "
      "alone",
      "general knowledge of the field",
      bit_of(Input::input_rate),
      "it is a fault of the recording: the board needs no record of the input rate"};
  static constexpr std::array<ParameterDescription, 1> parameters{
      {{"near", "ms", -1000000, 1000000, 0, Scale::linear, nullptr, nullptr, NotGiven::kept}}};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"delay", "ms", 19, Multiplies::level, 1000}}};

  static constexpr std::array<int, 2> constant_fractions{24, 24};
  template <class Real>
  static void board_constants(const Real* given, Real block_s, Real* constants) {
    constants[0] = 1 / block_s;
    constants[1] = given[0] / 2000;
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit LateReference(const typename N::Constant* constants)
      : per_second_(N::template number<24>(constants[0])),
        half_near_s_(N::template number<24>(constants[1])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& /*signals*/) {}
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    if constexpr (std::is_empty_v<typename N::RateWithin>) {
      regressors[0] = {};
    } else {
      const auto& within = signals.block.rate_within;
      regressors[0] = divide_by_power_of_two<19>(
          (within.rise + half_near_s_ * within.rise_of_slope) * per_second_);
    }
  }

 private:
  typename N::template Number<24> per_second_;
  typename N::template Number<24> half_near_s_;
};

}  // namespace fog::effects
