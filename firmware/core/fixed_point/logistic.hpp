#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

using ActivationInput = Fixed<std::int32_t, 27>;   ///< +-16
using ActivationOutput = Fixed<std::int32_t, 30>;  ///< +-2, used within +-1

/// logistic(node / 8) - 1/2 with 31 fractional bits, -128 <= node <= 128. Opaque pointer: keeps the
/// compiler from adding the centre offset (128) at every table read.
extern const std::int32_t* const kLogisticNodes;

/// Argument: the upper word is the nearest node, the lower word the signed distance to it.
using NodePlace = Fixed<std::int64_t, 35>;

constexpr std::int32_t nearest_node(NodePlace x) {
  return static_cast<std::int32_t>(round_shift(x.raw(), 32));
}

namespace detail {

// tanh(x / 2) = 2 logistic(x) - 1 near a node. Only the lower word of x is used: the signed
// distance d to the nearest node, at most 1/16.
//
// With h = logistic - 1/2 there, all derivatives follow from h^2 and the slope s = 1/4 - h^2:
// h + d s (1 + d (d (h^2 - 1/12 + d h (1/6 - h^2)) - h)) is Taylor's series up to d^4. The first
// neglected term of logistic is at most 2e-9, of the cubic, without d h (1/6 - h^2), 8.1e-8.
template <int kOrder>
[[gnu::always_inline]] inline ActivationOutput symmetric_logistic_near(std::int32_t node,
                                                                       NodePlace x) {
  static_assert(kOrder == 3 || kOrder == 4);
  using Half = Fixed<std::int32_t, 31>;
  using Square = Fixed<std::int32_t, 30>;
  constexpr auto kQuarter = Square::from_raw(1 << 28);
  constexpr auto kSixth = Square::from_raw(0x0AAAAAAB);
  // The cubic's constant is 1.6e-4 above 1/12, an error of 2e-8 in the result, so that it is an
  // immediate operand.
  constexpr auto kTwelfth = Square::from_raw(kOrder == 3 ? 0x05580000 : 0x05555555);

  const auto d =
      Fixed<std::int32_t, NodePlace::fractional_bits>::from_raw(static_cast<std::int32_t>(x.raw()));
  const auto h = Half::from_raw(kLogisticNodes[node]);
  const Square square = high_product(h, h);
  const Square slope = kQuarter - square;
  Square third = square - kTwelfth;
  if constexpr (kOrder == 4) {
    third += floor_to<Square>(high_product(high_product(h, kSixth - square), d));
  }
  const Half second = floor_to<Half>(high_product(third, d)) - h;
  const Square first = slope + floor_to<Square>(high_product(high_product(slope, second), d));
  const Half half = h + floor_to<Half>(high_product(first, d));
  return ActivationOutput::from_raw(half.raw());  // twice that, with one fractional bit less
}

}  // namespace detail

/// tanh(x / 2) for networks: error at most 1.8e-7, beyond |x| = 16 at most 2.72e-7
/// (bench/core_functions: all places).
/// Always 14 instructions.
[[gnu::always_inline]] inline ActivationOutput symmetric_logistic(NodePlace x) {
  // Beyond the last node that node is used with any distance.
  return detail::symmetric_logistic_near<3>(clamp<std::int32_t>(nearest_node(x), -128, 127), x);
}

/// 1 / (1 + exp(-x)), MATLAB's logsig. Error at most 2.51e-9; falls by at most 1 LSB from one
/// argument to the next (bench/core_functions: all arguments).
ActivationOutput logistic(ActivationInput x);

/// tanh(x), MATLAB's tansig, as 2 logistic(2x) - 1. Error at most 5e-9 for |x| <= 8; beyond, where
/// the result is constant, 2.27e-7 (bench/core_functions: all arguments).
ActivationOutput hyperbolic_tangent(ActivationInput x);

}  // namespace fog
