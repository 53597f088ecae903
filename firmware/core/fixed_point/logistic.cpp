#include "core/fixed_point/logistic.hpp"

#include "core/fixed_point/logistic_table.hpp"

namespace fog {
namespace {

constexpr int kNodeFraction = 4;  // nodes every 1/16

// round(2^30 / 6); the test "LogisticTable" recomputes it.
constexpr auto kSixth = ActivationOutput::from_raw(178956971);

// f(x) for x >= 0 by Taylor's series around the nearest node. The derivatives of the logistic
// function are polynomials in itself, so that one table serves all: with s = f (1 - f) the series
// is f + d (s + d (s (1/2 - f) + d s (1/6 - s))). The distance d to a node is at most 1/32; the
// first neglected term is max|f''''| / 24 * 2^-20 = 5e-9.
ActivationOutput logistic_of_positive(ActivationInput x) {
  constexpr int kDropped = ActivationInput::fractional_bits - kNodeFraction;
  constexpr auto kOne = from_integer<ActivationOutput>(1);
  constexpr auto kHalf = ActivationOutput::from_raw(kOne.raw() / 2);
  const auto product = [](auto a, auto b) { return round_to<ActivationOutput>(a * b); };

  const std::int32_t node = round_shift(x.raw(), kDropped);
  const auto distance = x - ActivationInput::from_raw(static_cast<std::int32_t>(
                                static_cast<std::uint32_t>(node) << kDropped));
  const auto f = ActivationOutput::from_raw(kLogisticTable[node]);
  const auto slope = product(f, kOne - f);
  auto series = product(slope, kSixth - slope);
  series = product(slope, kHalf - f) + product(series, distance);
  series = slope + product(series, distance);
  return f + product(series, distance);
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
