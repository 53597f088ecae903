#include "core/fixed_point/logistic.hpp"

#include "core/fixed_point/logistic_table.hpp"

namespace fog {

const std::int32_t* const kLogisticNodes = kLogisticTable + 128;

namespace {

ActivationOutput symmetric(ActivationInput x) {
  const auto place = round_to<NodePlace>(x);
  return detail::symmetric_logistic_near<4>(nearest_node(place), place);
}

}  // namespace

ActivationOutput logistic(ActivationInput x) {
  constexpr auto kHalf = ActivationOutput::from_raw(1 << 29);
  return kHalf + round_to<ActivationOutput>(divide_by_power_of_two<1>(symmetric(x)));
}

ActivationOutput hyperbolic_tangent(ActivationInput x) {
  using Wide = Fixed<std::int64_t, ActivationInput::fractional_bits>;
  return symmetric(saturate_to<ActivationInput>(Wide::from_raw(2 * std::int64_t{x.raw()})));
}

}  // namespace fog
