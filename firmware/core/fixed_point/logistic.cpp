#include "core/fixed_point/logistic.hpp"

#include "core/fixed_point/logistic_table.hpp"

namespace fog {
namespace {

constexpr int kNodeFraction = 4;  // nodes every 1/16

// f(x) for x >= 0 by Taylor's series around the nearest node, with f' = f (1 - f) and
// f'' = f' (1 - 2 f), so that one table serves all three. The distance to a node is at most 1/32;
// the first neglected term is max|f'''| / 6 * 2^-15 = 6.4e-7.
ActivationOutput logistic_of_positive(ActivationInput x) {
  constexpr int kDropped = ActivationInput::fractional_bits - kNodeFraction;
  const std::int32_t node = round_shift(x.raw(), kDropped);
  const auto distance = x - ActivationInput::from_raw(static_cast<std::int32_t>(
                                static_cast<std::uint32_t>(node) << kDropped));
  constexpr auto kOne = from_integer<ActivationOutput>(1);
  const auto f = ActivationOutput::from_raw(kLogisticTable[node]);
  const auto slope = round_to<ActivationOutput>(f * (kOne - f));
  const auto half_curvature =
      divide_by_power_of_two<1>(round_to<ActivationOutput>(slope * (kOne - f - f)));
  const auto tangent = slope + round_to<ActivationOutput>(half_curvature * distance);
  return f + round_to<ActivationOutput>(tangent * distance);
}

}  // namespace

ActivationOutput logistic(ActivationInput x) {
  if (x < ActivationInput{}) {
    // -lowest does not exist; its neighbour is as good at the far end of the curve.
    const auto positive = x == ActivationInput::lowest() ? ActivationInput::highest() : -x;
    return from_integer<ActivationOutput>(1) - logistic_of_positive(positive);
  }
  return logistic_of_positive(x);
}

ActivationOutput hyperbolic_tangent(ActivationInput x) {
  const auto doubled = saturate_to<ActivationInput>(
      Fixed<std::int64_t, ActivationInput::fractional_bits>::from_raw(2 * std::int64_t{x.raw()}));
  const ActivationOutput f = logistic(doubled);
  return f + f - from_integer<ActivationOutput>(1);
}

}  // namespace fog
