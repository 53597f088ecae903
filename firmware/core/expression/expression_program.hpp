#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/inputs.hpp"
#include "core/signal/span.hpp"

/* A drift term that is data: a program for a stack of 32-bit integers, made by fogcomp export from
   an expression. Which format a value has is known to the exporter alone, which chooses it so that
   nothing overflows; where a table says otherwise, every operation saturates. */

namespace fog {

/// One word: operation + 256 * argument (-62 to 62), followed by the words named here. `bits` is
/// the argument.
enum class ExpressionOp : std::uint8_t {
  signal = 0,     ///< + min, max: pushes the Input of number `bits`, clamped, in its format
  constant = 1,   ///< + value
  duplicate = 2,  ///< pushes the top once more
  over = 3,       ///< pushes the value below the top once more
  nip = 4,        ///< removes the value below the top
  shift = 5,      ///< round_shift by `bits`; to the left where negative, at most 31
  add = 6,
  subtract = 7,
  multiply = 8,  ///< round_shift(a * b, bits)
  divide = 9,  ///< round_divide(a * 2^bits, b), bits at most 30; the limit of a's sign where b is 0
  negate = 10,
  absolute = 11,
  min = 12,
  max = 13,
  sine = 14,    ///< of radians with `bits` fractional bits -> 30 fractional bits
  cosine = 15,  ///< the same
  decay = 16,   ///< exp(-x), x >= 0 with 26 fractional bits -> 30
  tanh = 17,    ///< 27 fractional bits -> 30
  lag = 18,     ///< + decay (31 fractional bits, > 0): through a first-order lag
  play = 19,    ///< + radius (>= 0): play operator
  output = 20,  ///< pops the next regressor; `bits` as for shift
};
constexpr std::size_t kExpressionOps = 21;

constexpr std::size_t kMaxExpressions = 8;       ///< outputs of a program
constexpr std::size_t kMaxExpressionStates = 8;  ///< lags and plays
constexpr std::size_t kMaxExpressionStack = 16;
constexpr std::size_t kMaxExpressionWords = 512;

/// Arguments of operations: of a shift to the left, of any other one, and of a division. An int32
/// shifted to the left fits 64 bits, and a dividend 63, as round_divide() needs.
constexpr std::int32_t kMaxLeftShift = 31;
constexpr std::int32_t kMaxRightShift = 62;
constexpr std::int32_t kMaxDivideBits = 30;
static_assert(31 + kMaxLeftShift <= 62 && 31 + kMaxDivideBits <= 61);

/// A play's input is clipped to this, and a larger radius is refused, so that their sum fits.
constexpr std::int32_t kMaxPlayInput = 1 << 30;
constexpr std::int32_t kMaxPlayRadius = (1 << 30) - 1;
static_assert(std::int64_t{kMaxPlayInput} + kMaxPlayRadius <= INT32_MAX);

/// Operations and, in the bits above them, inputs of a program; 0: no expressions.
using ExpressionMask = std::uint32_t;
constexpr ExpressionMask bit_of(ExpressionOp op) {
  return ExpressionMask{1} << static_cast<unsigned>(op);
}
constexpr ExpressionMask expression_bit_of(Input input) {
  return ExpressionMask{1} << (kExpressionOps + static_cast<unsigned>(input));
}
static_assert(kExpressionOps + kInputs <= 32, "widen ExpressionMask");
constexpr ExpressionMask kAllExpressions = ~ExpressionMask{0} >> (32U - kExpressionOps - kInputs);

/// The inputs that expressions with this mask use.
constexpr InputMask inputs_of_expressions(ExpressionMask mask) {
  return mask >> kExpressionOps;
}

/// The expressions of a model: one program with one output per coefficient.
struct ExpressionParameters {
  Span<const std::int32_t> program;
  Span<const std::int32_t> coefficients;  ///< deg/h, EffectsParameters::coefficient_fraction bits

  // Set by the check:
  ExpressionMask used = 0;  ///< by the program
  std::uint32_t waves = 0;  ///< sines and cosines, the dearest operations
};

/// Checks whether this image can run a program. Sets `used`.
using ExpressionCheck = bool (*)(ExpressionParameters& expressions);

/// Check of images with expressions: known operations with arguments in range and all their words,
/// no stack underflow or overflow, few enough states, as many outputs as coefficients.
bool expressions_fit(ExpressionParameters& expressions);

/// Stub for images built without expressions: rejects every program.
inline bool expressions_unknown(ExpressionParameters& expressions) {
  expressions.used = expressions.program.size == 0 ? 0U : kAllExpressions;
  return expressions.program.size != 0 || expressions.coefficients.size == 0;
}

/// The check of an image with kCompiled.
template <ExpressionMask kCompiled>
constexpr ExpressionCheck expression_check() {
  return kCompiled == 0U ? expressions_unknown : expressions_fit;
}

/// Words of an operation, including its own.
std::size_t words_of(ExpressionOp op);

constexpr ExpressionOp op_of(std::int32_t word) {
  return static_cast<ExpressionOp>(static_cast<std::uint32_t>(word) & 0xFFU);
}

}  // namespace fog
