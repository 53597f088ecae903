#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::board {

/// An expression in the integers of fog::ExpressionBank.
struct ExpressionCode {
  std::vector<std::int32_t> words;
  double max = 0;    ///< bound of |regressor|, by interval analysis over the signals' ranges
  double error = 0;  ///< bound of the regressor's error relative to double
};

/// Compiles one term that is an expression, for blocks of `block_s`. Interval analysis over the
/// trained temperatures and the signals' ranges gives the range of every node, hence its format
/// (one spare bit), and the bound of its error: roundings, errors of the functions and of the
/// temperature rate. Throws InputError, with the reason, for operations that the board cannot do: a
/// divisor that may be 0, non-integer powers, values beyond 32 bits.
ExpressionCode compile_expression(const model::EffectTerm& term, const model::Model& model,
                                  double block_s);

}  // namespace fogcomp::board
