#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/fixed_point/logistic_table.hpp"

namespace fog {

using ActivationInput = Fixed<std::int32_t, 27>;   ///< +-16
using ActivationOutput = Fixed<std::int32_t, 30>;  ///< +-2, used within +-1

/// tanh(x / 2) = 2 logistic(x) - 1, within 1.6e-8 (test: a sweep); beyond |x| = 16 what it is
/// there, within 2.3e-7. `magnitude` is |x|, with the fraction of ActivationInput; `sign` all bits
/// if x is negative, else none. Always the same number of instructions, some 20.
///
/// With h = logistic - 1/2 at the nearest node of a table, all derivatives follow from the slope
/// s = 1/4 - h^2, and Taylor's series is h + d (s + d (d s (1/6 - s) - s h)). The distance d to a
/// node is at most 1/32; the first neglected term is max|fourth derivative| / 24 * 2^-20 = 5e-9.
[[gnu::always_inline]] inline ActivationOutput symmetric_logistic(std::uint32_t magnitude,
                                                                  std::uint32_t sign) {
  constexpr int kNodeFraction = 4;  // nodes every 1/16
  constexpr int kDropped = ActivationInput::fractional_bits - kNodeFraction;
  using Half = Fixed<std::int32_t, 31>;
  using Slope = Fixed<std::int32_t, 30>;
  using Distance = Fixed<std::int32_t, 32 + kNodeFraction>;
  constexpr auto kQuarter = Slope::from_raw(1 << 28);
  // Less 1.6e-4, by which the result is off by 1.3e-9: kQuarter - kSixth fits into an instruction.
  constexpr auto kSixth = Slope::from_raw(0x0AA80000);

  const std::uint32_t node = (magnitude + (1U << (kDropped - 1))) >> kDropped;
  // The node's bits leave at the top; what stays is signed, as the node is the nearest.
  const auto d = Distance::from_raw(static_cast<std::int32_t>(magnitude << (32 - kDropped)));

  const auto h = Half::from_raw(kLogisticTable[node]);
  const Slope slope = kQuarter - high_product(h, h);
  const auto third = high_product(slope, kSixth - slope);
  const auto bend = high_product(slope, h);
  const auto second = floor_to<decltype(bend)>(high_product(third, d)) - bend;
  const auto first = slope + floor_to<Slope>(high_product(second, d));
  const auto half = h + floor_to<Half>(high_product(first, d));
  // Twice that has the same raw number, with one fractional bit less.
  return ActivationOutput::from_raw(
      static_cast<std::int32_t>(static_cast<std::uint32_t>(half.raw()) ^ sign));
}

/// 1 / (1 + exp(-x)), MATLAB's logsig. Error at most 1e-8 (test: a sweep of its range); monotonic
/// to within it.
ActivationOutput logistic(ActivationInput x);

/// tanh(x), MATLAB's tansig, as 2 logistic(2x) - 1. Error at most 2e-8 for |x| <= 8; beyond, where
/// the result stays what it is at 8, 2.3e-7 (test: a sweep of its range).
ActivationOutput hyperbolic_tangent(ActivationInput x);

}  // namespace fog
