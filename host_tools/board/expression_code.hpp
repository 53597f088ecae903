#pragma once

#include <cstdint>
#include <vector>

#include "model/model.hpp"

namespace fogcomp::board {

/// An expression in the integers of fog::ExpressionBank.
struct ExpressionCode {
  std::vector<std::int32_t> words;
  double max = 0;    ///< of |regressor|, by interval analysis over the signals' ranges
  double error = 0;  ///< of the regressor against double, at most
};

/// Compiles one term that is an expression, for blocks of `block_s`. Interval analysis over the
/// trained temperatures and the signals' ranges gives every node its range, from that its format
/// (one spare bit), and the bound of its error: roundings, the errors of the functions, the
/// temperature rate's own. Throws InputError, saying why, for what the board cannot do: a divisor
/// that may be 0, powers that are not whole, values beyond 32 bits.
ExpressionCode compile_expression(const model::EffectTerm& term, const model::Model& model,
                                  double block_s);

}  // namespace fogcomp::board
