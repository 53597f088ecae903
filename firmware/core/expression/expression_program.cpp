#include "core/expression/expression_program.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {
namespace {

// Effect of an operation on the stack: values removed, values added.
struct Effect {
  std::size_t takes;
  std::size_t leaves;
};

Effect effect_of(ExpressionOp op) {
  switch (op) {
    case ExpressionOp::signal:
    case ExpressionOp::constant:
      return {0, 1};
    case ExpressionOp::duplicate:
      return {1, 2};
    case ExpressionOp::over:
      return {2, 3};
    case ExpressionOp::nip:
    case ExpressionOp::add:
    case ExpressionOp::subtract:
    case ExpressionOp::multiply:
    case ExpressionOp::divide:
    case ExpressionOp::min:
    case ExpressionOp::max:
      return {2, 1};
    case ExpressionOp::output:
      return {1, 0};
    case ExpressionOp::shift:
    case ExpressionOp::negate:
    case ExpressionOp::absolute:
    case ExpressionOp::sine:
    case ExpressionOp::cosine:
    case ExpressionOp::decay:
    case ExpressionOp::tanh:
    case ExpressionOp::lag:
    case ExpressionOp::play:
      break;
  }
  return {1, 1};
}

bool operands_fit(ExpressionOp op, const std::int32_t* words) {
  const std::int32_t bits = floor_shift(words[0], 8);
  switch (op) {
    case ExpressionOp::signal:
      return bits >= 0 && bits < static_cast<std::int32_t>(kInputs) && words[1] <= words[2];
    case ExpressionOp::shift:
    case ExpressionOp::output:
      return bits >= -kMaxLeftShift && bits <= kMaxRightShift;
    case ExpressionOp::multiply:
    case ExpressionOp::sine:
    case ExpressionOp::cosine:
      return bits >= 0 && bits <= kMaxRightShift;
    case ExpressionOp::divide:
      return bits >= 0 && bits <= kMaxDivideBits;
    case ExpressionOp::lag:
      return bits == 0 && words[1] > 0;
    case ExpressionOp::play:
      return bits == 0 && words[1] >= 0 && words[1] <= kMaxPlayRadius;
    default:
      return bits == 0;
  }
}

}  // namespace

std::size_t words_of(ExpressionOp op) {
  switch (op) {
    case ExpressionOp::signal:
      return 3;
    case ExpressionOp::constant:
    case ExpressionOp::lag:
    case ExpressionOp::play:
      return 2;
    default:
      return 1;
  }
}

bool expressions_fit(ExpressionParameters& expressions) {
  const Span<const std::int32_t> program = expressions.program;
  std::size_t depth = 0;
  std::size_t states = 0;
  std::size_t outputs = 0;
  std::size_t at = 0;
  expressions.used = 0;
  expressions.waves = 0;
  while (at < program.size) {
    const ExpressionOp op = op_of(program[at]);
    if (static_cast<std::size_t>(op) >= kExpressionOps) return false;
    if (words_of(op) > program.size - at || !operands_fit(op, program.data + at)) return false;
    expressions.used |= bit_of(op);
    if (op == ExpressionOp::signal) {
      expressions.used |= expression_bit_of(static_cast<Input>(floor_shift(program[at], 8)));
    }
    const Effect effect = effect_of(op);
    if (depth < effect.takes) return false;
    depth = depth - effect.takes + effect.leaves;
    states += op == ExpressionOp::lag || op == ExpressionOp::play ? 1 : 0;
    expressions.waves += op == ExpressionOp::sine || op == ExpressionOp::cosine ? 1 : 0;
    outputs += op == ExpressionOp::output ? 1 : 0;
    if (depth > kMaxExpressionStack || states > kMaxExpressionStates) return false;
    at += words_of(op);
  }
  return depth == 0 && outputs == expressions.coefficients.size && outputs <= kMaxExpressions;
}

}  // namespace fog
