#include "board/table_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/expression/expression_program.hpp"
#include "core/fixed_point/fixed.hpp"
#include "core/signal/quantities.hpp"
#include "model/drift_model.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::board {
namespace {

using Op = fog::ExpressionOp;

constexpr int kUsedBits = 30;  // bits used by a value; one is spare
constexpr int kMaxFraction = 58;
constexpr int kMaxPower = 16;
// Errors of the core's functions, from their headers.
constexpr double kSineError = 4.32e-9;
constexpr double kDecayError = 1.54e-9;
constexpr double kTanhError = 2.27e-7;
constexpr int kWaveFraction = 30;   // output of sine, cosine, decay and tanh
constexpr int kDecayFraction = 26;  // input of decay
constexpr int kTanhFraction = 27;   // input of tanh

// A value on the board's stack: real range, error bound, fractional bits.
struct Value {
  double min = 0;
  double max = 0;
  double error = 0;
  int fraction = 0;

  double size() const { return std::max(std::abs(min), std::abs(max)); }
};

double half_lsb(int fraction) {
  return std::ldexp(0.5, -fraction);
}

// Fractional bits with which a value of this size uses kUsedBits.
int fraction_for(double size) {
  return size > 0 ? std::min(kMaxFraction, kUsedBits - 1 - std::ilogb(size)) : kUsedBits;
}

class Compiler {
 public:
  Compiler(const model::EffectTerm& term, const model::Model& model, double block_s)
      : term_(term),
        expression_(term.expression->expression),
        constants_(expression_.constants(term.shape())),
        model_(model),
        block_s_(block_s),
        known_(expression_.nodes.size()) {}

  ExpressionCode compile() {
    const Value value = node(expression_.nodes.size() - 1);
    const int scale = term_.expression->scale_log2;
    constexpr int kRegressor = fog::Regressor::fractional_bits;
    const int shift = value.fraction + scale - kRegressor;
    if (shift < -31 || shift > 62) refuse("its regressor's scale is out of range");
    emit(Op::output, shift);
    code_.max = std::ldexp(value.size(), -scale);
    code_.error = std::ldexp(value.error, -scale) + half_lsb(kRegressor);
    return std::move(code_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("expression '" + term_.name + "'",
                     "cannot go to the board: " + why + "; write it otherwise, or fit without it");
  }

  void emit(Op op, int bits = 0) {
    code_.words.push_back(static_cast<std::int32_t>(op) + 256 * bits);
    if (code_.words.size() > fog::kMaxExpressionWords) refuse("it is too long");
  }
  void emit_word(double raw) {
    if (!(std::abs(raw) <= 2147483647.0)) refuse("a value is beyond 32 bits");
    code_.words.push_back(static_cast<std::int32_t>(std::llround(raw)));
  }

  // Converts the value on top to other fractional bits.
  Value in_format(Value value, int fraction) {
    const int dropped = value.fraction - fraction;
    if (dropped == 0) return value;
    if (dropped < -31 || dropped > 62) refuse("operands differ too much in size");
    emit(Op::shift, dropped);
    if (dropped > 0) value.error += half_lsb(fraction);
    value.fraction = fraction;
    return value;
  }
  // Checks that a result's size fits a format.
  Value checked(const Value& value) const {
    if (!(value.size() < 2147483648.0) || !(value.error < 1e9)) {
      refuse("a value could become larger than 2^31");
    }
    return value;
  }

  Value constant(double value) {
    const int fraction = fraction_for(std::abs(value));
    emit(Op::constant);
    emit_word(std::ldexp(value, fraction));
    return {value, value, half_lsb(fraction), fraction};
  }

  Value signal(fog::Input which) {
    model::SignalRange range = term_.expression->ranges[static_cast<std::size_t>(which)];
    if (which == fog::Input::elapsed) return elapsed(range);
    if (which == fog::Input::temperature) {
      range = {std::max({range.min, model_.min_degc, -70.0}),
               std::min({range.max, model_.max_degc, 130.0})};
    }
    const int fraction = description_of(which).fraction;
    const double own_error = which == fog::Input::temperature_rate ? rate_error() : 0;
    push_signal(which, range.min, range.max, fraction);
    // rounding of the clamp itself
    return {range.min, range.max, own_error + half_lsb(fraction), fraction};
  }

  void push_signal(fog::Input which, double min, double max, int fraction) {
    emit(Op::signal, static_cast<int>(which));
    emit_word(std::ldexp(min, fraction));
    emit_word(std::ldexp(max, fraction));
  }

  // Number of blocks times their length.
  Value elapsed(const model::SignalRange& range) {
    const double max_blocks = std::min(range.max / block_s_, 2147483647.0);
    push_signal(fog::Input::elapsed, 0, max_blocks, 0);
    // Near the maximum time, a non-integer number of blocks is off by up to a half.
    const double off = std::abs(max_blocks - std::round(max_blocks)) < 1e-6 ? 1e-6 : 0.5;
    const Value blocks{0, max_blocks, off, 0};
    return product(blocks, constant(block_s_));
  }

  // The two lags of the derivative rest within half an LSB of 22 bits each; their difference is
  // rounded to 26 bits, the decay to 31 and the gain to 24.
  double rate_error() const {
    const auto real = model::thermal_parameters(model_, block_s_).derivative;
    const double lags = 3 * half_lsb(22) + half_lsb(26);
    const double rate = fog::kMaxRateDegcPerMin;
    return lags * real.rate_gain + rate * (half_lsb(24) / real.rate_gain) +
           4 * rate * half_lsb(31) / real.decay + half_lsb(fog::TemperatureRate::fractional_bits);
  }

  // Product of two values on the stack.
  Value product(const Value& a, const Value& b) {
    const double corners[] = {a.min * b.min, a.min * b.max, a.max * b.min, a.max * b.max};
    Value result;
    result.min = *std::min_element(std::begin(corners), std::end(corners));
    result.max = *std::max_element(std::begin(corners), std::end(corners));
    result.error = a.size() * b.error + b.size() * a.error + a.error * b.error;
    return multiplied(result, a.fraction + b.fraction);
  }
  Value multiplied(Value result, int exact_fraction) {
    checked(result);
    result.fraction = std::min(fraction_for(result.size()), exact_fraction);
    if (exact_fraction - result.fraction > 62) refuse("operands differ too much in size");
    emit(Op::multiply, exact_fraction - result.fraction);
    result.error += half_lsb(result.fraction);
    return result;
  }

  // Negates the value on the stack.
  Value negated(const Value& x) {
    emit(Op::negate);
    return {-x.max, -x.min, x.error, x.fraction};
  }
  Value magnitude(const Value& x) {
    emit(Op::absolute);
    const bool crosses = x.min < 0 && x.max > 0;
    const double min = crosses ? 0 : std::min(std::abs(x.min), std::abs(x.max));
    return {min, x.size(), x.error, x.fraction};
  }
  Value tangent(const Value& argument) {
    const Value x = in_format(argument, kTanhFraction);
    emit(Op::tanh);
    return {std::tanh(x.min), std::tanh(x.max), x.error + kTanhError, kWaveFraction};
  }

  Value node(std::size_t index) {
    const model::ExpressionNode& now = expression_.nodes[index];
    if (now.constant) return constant(constants_[index]);
    switch (now.kind) {
      case model::NodeKind::signal:
        return signal(now.signal);
      case model::NodeKind::add:
      case model::NodeKind::subtract:
      case model::NodeKind::minimum:
      case model::NodeKind::maximum:
        return sum(now);
      case model::NodeKind::multiply: {
        const Value left = node(now.left);
        return product(left, node(now.right));
      }
      case model::NodeKind::divide:
        return quotient(now);
      case model::NodeKind::power:
        return power(node(now.left), constants_[now.right]);
      case model::NodeKind::negate:
        return negated(node(now.left));
      case model::NodeKind::absolute:
        return magnitude(node(now.left));
      case model::NodeKind::sine:
      case model::NodeKind::cosine:
        return wave(now);
      case model::NodeKind::exponential:
        return exponential(now.left);
      case model::NodeKind::hyperbolic_tangent:
        return tangent(node(now.left));
      case model::NodeKind::lag:
        return lag(now);
      case model::NodeKind::play:
        return play(now);
      case model::NodeKind::highest:  // as model::after_exposure() has it
        return constant(model_.max_degc);
      case model::NodeKind::number:
      case model::NodeKind::parameter:
        break;
    }
    return constant(constants_[index]);
  }

  // The format of a sum's operands depends on both, so they are first compiled to learn their
  // ranges.
  Value trial(std::size_t index) {
    if (!known_[index]) {
      const ExpressionCode saved = code_;
      known_[index] = node(index);
      code_ = saved;
    }
    return *known_[index];
  }

  Value sum(const model::ExpressionNode& now) {
    const Value a = trial(now.left);
    const Value b = trial(now.right);
    Value result;
    if (now.kind == model::NodeKind::add) {
      result = {a.min + b.min, a.max + b.max, 0, 0};
    } else if (now.kind == model::NodeKind::subtract) {
      result = {a.min - b.max, a.max - b.min, 0, 0};
    } else if (now.kind == model::NodeKind::minimum) {
      result = {std::min(a.min, b.min), std::min(a.max, b.max), 0, 0};
    } else {
      result = {std::max(a.min, b.min), std::max(a.max, b.max), 0, 0};
    }
    checked(result);
    const int fraction = std::min(
        {a.fraction, b.fraction, fraction_for(std::max({a.size(), b.size(), result.size()}))});
    const Value left = in_format(node(now.left), fraction);
    const Value right = in_format(node(now.right), fraction);
    const bool chooses =
        now.kind == model::NodeKind::minimum || now.kind == model::NodeKind::maximum;
    emit(now.kind == model::NodeKind::add        ? Op::add
         : now.kind == model::NodeKind::subtract ? Op::subtract
         : now.kind == model::NodeKind::minimum  ? Op::min
                                                 : Op::max);
    result.error = chooses ? std::max(left.error, right.error) : left.error + right.error;
    result.fraction = fraction;
    return result;
  }

  Value quotient(const model::ExpressionNode& now) {
    if (expression_.nodes[now.right].constant) {
      const double divisor = constants_[now.right];
      if (divisor == 0) refuse("it divides by 0");
      const Value left = node(now.left);
      return product(left, constant(1 / divisor));
    }
    const Value b = trial(now.right);
    const Value a = trial(now.left);
    const double nearest = b.min > 0 ? b.min : -b.max;
    if (!(nearest > 2 * b.error)) {
      refuse(format("a divisor goes from %.4g to %.4g within the ranges that it was fitted in",
                    b.min, b.max));
    }
    const double corners[] = {a.min / b.min, a.min / b.max, a.max / b.min, a.max / b.max};
    Value result;
    result.min = *std::min_element(std::begin(corners), std::end(corners));
    result.max = *std::max_element(std::begin(corners), std::end(corners));
    checked(result);
    result.fraction = std::min(fraction_for(result.size()), a.fraction - b.fraction + 30);
    const int left_fraction = std::min(a.fraction, result.fraction + b.fraction);
    const Value left = in_format(node(now.left), left_fraction);
    const Value right = node(now.right);
    emit(Op::divide, result.fraction - left_fraction + right.fraction);
    result.error = (left.error + result.size() * right.error) / (nearest - right.error) +
                   half_lsb(result.fraction);
    return result;
  }

  // Raises x on the stack to a whole power.
  Value power(const Value& x, double exponent) {
    if (exponent != std::round(exponent) || std::abs(exponent) > kMaxPower || exponent == 0) {
      refuse(format("a power of %.6g; it has whole powers from -%d to %d but 0", exponent,
                    kMaxPower, kMaxPower));
    }
    if (exponent < 0) {
      refuse("a negative power; write a division");
    }
    if (exponent == 1) return x;
    emit(Op::duplicate);
    Value result = x;
    for (int n = 2; n <= static_cast<int>(exponent); ++n) {
      emit(Op::over);
      // Both factors are equal: the range is that of the power, the error that of a product.
      const double ends[] = {std::pow(x.min, n), std::pow(x.max, n)};
      const bool turns = n % 2 == 0 && x.min < 0 && x.max > 0;
      Value next{turns ? 0 : std::min(ends[0], ends[1]), std::max(ends[0], ends[1]), 0, 0};
      next.error = result.size() * x.error + x.size() * result.error + x.error * result.error;
      result = multiplied(next, result.fraction + x.fraction);
    }
    emit(Op::nip);
    return result;
  }

  Value wave(const model::ExpressionNode& now) {
    Value x = node(now.left);
    if (x.fraction < 0) refuse("an angle could become larger than 2^30");
    emit(now.kind == model::NodeKind::sine ? Op::sine : Op::cosine, x.fraction);
    return {-1, 1, x.error + kSineError + x.size() * half_lsb(30) + half_lsb(30), kWaveFraction};
  }

  // exp(x) = exp(max) exp(-(max - x)).
  Value exponential(std::size_t operand) {
    const Value x = trial(operand);
    const double factor = std::exp(x.max);
    if (!(factor < 1073741824.0)) refuse(format("exp() of up to %.4g is too large", x.max));
    const int fraction = std::min(x.fraction, fraction_for(std::max(x.size(), x.max - x.min)));
    emit(Op::constant);
    emit_word(std::ldexp(x.max, fraction));
    const Value right = in_format(node(operand), fraction);
    emit(Op::subtract);
    Value below{0, x.max - x.min, right.error + half_lsb(fraction), fraction};
    below = in_format(below, kDecayFraction);  // clips at 32
    emit(Op::decay);
    constexpr double kBeyond = 1.3e-14;  // exp(-32)
    const Value share{std::exp(-below.max), 1, below.error + kDecayError + kBeyond, kWaveFraction};
    Value result = product(share, constant(factor));
    result.min = std::exp(x.min);
    return result;
  }

  // Lags and plays keep the format, so the value gets the finest possible one.
  Value lag(const model::ExpressionNode& now) {
    const double tau_s = constants_[now.right];
    if (!(tau_s > 0)) refuse("a lag's time constant is not above 0");
    const double decay = model::RealNumbers::decay(block_s_ / tau_s);
    Value x = node(now.left);
    x = in_format(x, std::max(x.fraction, fraction_for(x.size())));
    emit(Op::lag);
    emit_word(std::ldexp(decay, 31));
    if (code_.words.back() == 0) refuse("a lag's time constant is too long");
    x.error += 2 * half_lsb(x.fraction) + (x.max - x.min) * half_lsb(31) / decay;
    return x;
  }

  Value play(const model::ExpressionNode& now) {
    const double radius = constants_[now.right];
    Value x = node(now.left);
    if (!(radius >= 0 && radius < 1e9)) refuse("a play's radius is below 0 or out of range");
    x = in_format(x, std::min(std::max(x.fraction, fraction_for(x.size())), fraction_for(radius)));
    emit(Op::play);
    emit_word(std::min<double>(std::ldexp(radius, x.fraction), fog::kMaxPlayRadius));
    x.error += half_lsb(x.fraction);
    return x;
  }

  const model::EffectTerm& term_;
  const model::Expression& expression_;
  std::vector<double> constants_;
  const model::Model& model_;
  double block_s_;
  std::vector<std::optional<Value>> known_;
  ExpressionCode code_;
};

}  // namespace

ExpressionCode compile_expression(const model::EffectTerm& term, const model::Model& model,
                                  double block_s) {
  return Compiler(term, model, block_s).compile();
}

}  // namespace fogcomp::board
