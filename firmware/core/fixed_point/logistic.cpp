#include "core/fixed_point/logistic.hpp"

namespace fog {
namespace {

ActivationOutput symmetric(ActivationInput x) {
  const auto sign = static_cast<std::uint32_t>(floor_shift(x.raw(), 31));
  return symmetric_logistic((static_cast<std::uint32_t>(x.raw()) ^ sign) - sign, sign);
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
