#pragma once

#include <array>

#include "core/effects/effect.hpp"

namespace fog::effects {

/// The clock of the recorded input rate is late: the record at time t shows the rotation at t -
/// delay. This is a fault of the recording; a fit uses the effect to keep it out of the scale
/// factor's coefficients.
///
/// The regressor is dW/dt / 2^19 deg/h/s, with dW/dt in the middle of a block from its mean and the
/// two before: (3 W0 - 4 W1 + W2) / 2, exact for a parabola. The first block after a start has 0,
/// the second the slope of a straight line.
template <class N>
class LateReference : public NoParameters {
 public:
  static constexpr EffectDescription description{
      "late_reference",
      20,
      "clock of the input rate's record behind the gyro's",
      "b = delay dW/dt, W the input rate",
      "1 to 100 ms, negative where the gyro's clock is behind",
      "delay=20",
      "where the input rate changes: in sweeps, with 90 degrees of phase; in steps at their flanks "
      "alone",
      "general knowledge of the field",
      bit_of(Input::input_rate),
      "it is a fault of the recording: the board needs no record of the input rate"};
  static constexpr std::array<CoefficientDescription, 1> coefficients{
      {{"delay", "ms", 19, Multiplies::level, 1000}}};

  static constexpr std::array<int, 1> constant_fractions{24};
  template <class Real>
  static void board_constants(const Real* /*given*/, Real block_s, Real* constants) {
    constants[0] = 1 / block_s;
  }
  static bool constants_valid(const typename N::Constant* constants) { return constants[0] > 0; }

  explicit LateReference(const typename N::Constant* constants)
      : per_second_(N::template number<24>(constants[0])) {}

  std::size_t regressor_count() const { return 1; }
  void reset(const Signals<N>& signals) {
    before_ = signals.block.input_rate;
    blocks_ = 0;
  }
  void step(const Signals<N>& signals, typename N::Regressor* regressors) {
    const Rate change = blocks_ > 0 ? signals.block.input_rate - before_ : Rate{};
    const Rate bend = blocks_ > 1 ? change - last_change_ : Rate{};
    const Rate centred = change + round_to<Rate>(divide_by_power_of_two<1>(bend));
    regressors[0] =
        saturate_to<typename N::Regressor>(divide_by_power_of_two<19>(centred * per_second_));
    before_ = signals.block.input_rate;
    last_change_ = change;
    if (blocks_ < 2) ++blocks_;
  }

 private:
  using Rate = typename N::Rate;

  typename N::template Number<24> per_second_;
  Rate before_{};
  Rate last_change_{};
  int blocks_ = 0;  // since the start, up to 2
};

}  // namespace fog::effects
