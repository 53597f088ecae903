#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/expression/expression_program.hpp"
#include "core/fixed_point/exponential.hpp"
#include "core/fixed_point/logistic.hpp"
#include "core/fixed_point/rounded_product.hpp"
#include "core/fixed_point/sine.hpp"
#include "core/signal/weighted_sum.hpp"
#include "core/thermal/first_order_lag.hpp"
#include "core/thermal/play.hpp"
#include "core/thermal/signals.hpp"

namespace fog {

/// Runs the expressions of a model, once per block. Operations and signals outside kCompiled have
/// no code in the image; read_model refuses a table that uses one.
template <ExpressionMask kCompiled>
class ExpressionBank {
 public:
  using BoardSignals = Signals<BoardNumbers>;

  ExpressionBank(const ExpressionParameters& parameters, int coefficient_fraction)
      : parameters_(parameters), coefficient_fraction_(coefficient_fraction) {}

  /// Starts all states from `signals`.
  void reset(const BoardSignals& signals) { run(signals, true); }

  /// Advances all states by one block and returns the drift of the expressions.
  DriftSum step(const BoardSignals& signals) {
    run(signals, false);
    return weighted_sum(parameters_.coefficients, regressors_.data(), coefficient_fraction_);
  }

  /// Whether no play operator depends any more on what happened before the start.
  bool history_known() const { return history_known_; }

  /// As that of EffectBank.
  void forget_history() {
    if constexpr (has(Op::play)) {
      for (State& state : states_) state.play.forget_history();
    }
  }

  /// Whether a signal was outside its range in the last run. The time may be: what it still does
  /// after a training ends with it.
  bool clamped() const { return clamped_; }

  void carry(StateCarrier& state) {
    if constexpr (has(Op::lag) || has(Op::play)) {
      if (parameters_.program.size > 0) state(states_);
    }
  }

  /// Results of the last run, for the host's check of an export.
  const std::array<Regressor, kMaxExpressions>& regressors() const { return regressors_; }

 private:
  using Op = ExpressionOp;
  static constexpr InputMask kInputs = inputs_of_expressions(kCompiled);
  using Lag = FirstOrderLag<BoardNumbers>;
  using Play = fog::Play<BoardNumbers>;

  // Lag and play are homogeneous, so they accept values in any format as if these had the 22
  // fractional bits of a temperature.
  struct State {
    Lag lag{Lag::Decay{}};
    Play play{Play::Value{}};
  };

  static constexpr bool has(Op op) { return (kCompiled & bit_of(op)) != 0U; }

  static std::int32_t narrow(std::int64_t value) { return saturate<std::int32_t>(value); }
  static std::int32_t shifted(std::int32_t value, int bits) {
    if (bits >= 0) return narrow(round_shift(std::int64_t{value}, bits));
    return narrow(shift_left(std::int64_t{value}, -bits));
  }

  std::int32_t in_range(std::int32_t value, std::int32_t min, std::int32_t max, Input input) {
    const std::int32_t held = clamp(value, min, max);
    clamped_ = clamped_ || (held != value && input != Input::elapsed);
    return held;
  }

  static std::int32_t quotient(std::int32_t a, std::int32_t b, int bits) {
    constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
    if (b == 0) return a < 0 ? -kMax : kMax;
    const std::int64_t numerator = shift_left(std::int64_t{a}, bits);
    if (b > 0) return narrow(round_divide(numerator, b));
    return narrow(round_divide(-numerator, b < -kMax ? kMax : -b));
  }

  static SineCosine wave(std::int32_t radians, int fraction) {
    // 2^32 / (2 pi); the test "SineTable" recomputes it.
    constexpr std::int64_t kTurnsPerRadian = 683565276;
    static_assert(kTurnsPerRadian <= floor_shift(INT64_MAX, 31));
    return sine_cosine(
        static_cast<std::uint32_t>(round_shift(radians * kTurnsPerRadian, fraction)));
  }

  static std::int32_t step_lag(State& state, std::int32_t x, std::int32_t decay, bool restart) {
    const auto input = round_to<Lag::State>(Play::Value::from_raw(x));
    if (restart) {
      state.lag = Lag(Lag::Decay::from_raw(decay));
      state.lag.reset(input);
    }
    return narrow(round_to<Fixed<std::int64_t, 22>>(state.lag.step(input)).raw());
  }

  std::int32_t play(State& state, std::int32_t x, std::int32_t radius, bool restart) {
    constexpr auto kMax = Play::Value::from_raw(kMaxPlayInput);
    const auto input = clamp(Play::Value::from_raw(x), -kMax, kMax);
    if (restart) {
      state.play.set_radius(Play::Value::from_raw(radius));
      state.play.start(input);
    }
    if (clamped_) state.play.forget_history();
    const std::int32_t y = (input - state.play.step(input)).raw();
    history_known_ = history_known_ && state.play.history_known();
    return y;
  }

  // expressions_fit() has checked that words, stack and states suffice.
  void run(const BoardSignals& signals, bool restart) {
    std::array<std::int32_t, kMaxExpressionStack + 1> stack;  // the top is in `x`
    std::int32_t* below = stack.data();
    std::int32_t x = 0;
    State* state = states_.data();
    Regressor* regressor = regressors_.data();
    const std::int32_t* word = parameters_.program.data;
    const std::int32_t* const end = word + parameters_.program.size;
    history_known_ = true;
    clamped_ = false;
    const auto push = [&](std::int32_t value) {
      *below++ = x;
      x = value;
    };
    while (word != end) {
      const Op op = op_of(*word);
      const int bits = floor_shift(*word, 8);
      ++word;
      switch (op) {
        case Op::signal:
          push(in_range(raw_value<kInputs>(signals, static_cast<Input>(bits)), word[0], word[1],
                        static_cast<Input>(bits)));
          word += 2;
          break;
        case Op::constant:
          push(*word++);
          break;
        case Op::duplicate:
          push(x);
          break;
        case Op::over:
          push(below[-1]);
          break;
        case Op::nip:
          --below;
          break;
        case Op::shift:
          x = shifted(x, bits);
          break;
        case Op::add:
          x = narrow(std::int64_t{*--below} + x);
          break;
        case Op::subtract:
          x = narrow(std::int64_t{*--below} - x);
          break;
        case Op::multiply:
          x = narrow(rounded_product(*--below, x, bits));
          break;
        case Op::divide:
          if constexpr (has(Op::divide)) x = quotient(*--below, x, bits);
          break;
        case Op::negate:
          x = narrow(-std::int64_t{x});
          break;
        case Op::absolute:
          x = narrow(x < 0 ? -std::int64_t{x} : x);
          break;
        case Op::min:
          x = clamp(x, std::numeric_limits<std::int32_t>::min(), *--below);
          break;
        case Op::max:
          x = clamp(x, *--below, std::numeric_limits<std::int32_t>::max());
          break;
        case Op::sine:
          if constexpr (has(Op::sine)) x = wave(x, bits).sine.raw();
          break;
        case Op::cosine:
          if constexpr (has(Op::cosine)) x = wave(x, bits).cosine.raw();
          break;
        case Op::decay:
          if constexpr (has(Op::decay)) {
            x = exponential_decay(Fixed<std::int32_t, 26>::from_raw(x)).raw();
          }
          break;
        case Op::tanh:
          if constexpr (has(Op::tanh)) x = hyperbolic_tangent(ActivationInput::from_raw(x)).raw();
          break;
        case Op::lag:
          if constexpr (has(Op::lag)) x = step_lag(*state++, x, *word++, restart);
          break;
        case Op::play:
          if constexpr (has(Op::play)) x = play(*state++, x, *word++, restart);
          break;
        case Op::output:
          *regressor++ = Regressor::from_raw(shifted(x, bits));
          x = *--below;
          break;
      }
    }
  }

  const ExpressionParameters& parameters_;
  int coefficient_fraction_;
  bool history_known_ = true;
  bool clamped_ = false;
  std::array<Regressor, kMaxExpressions> regressors_{};
  std::array<State, has(Op::lag) || has(Op::play) ? kMaxExpressionStates : 1> states_{};
};

/// Image without expressions: no state, no code.
template <>
class ExpressionBank<0> {
 public:
  ExpressionBank(const ExpressionParameters& /*parameters*/, int /*coefficient_fraction*/) {}
  void reset(const Signals<BoardNumbers>& /*signals*/) {}
  DriftSum step(const Signals<BoardNumbers>& /*signals*/) { return {}; }
  bool history_known() const { return true; }
  void forget_history() {}
  bool clamped() const { return false; }
  void carry(StateCarrier& /*state*/) {}
};

}  // namespace fog
