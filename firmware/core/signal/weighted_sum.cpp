#include "core/signal/weighted_sum.hpp"

namespace fog {

DriftSum weighted_sum(Span<const std::int32_t> coefficients, const Regressor* regressors,
                      int coefficient_fraction) {
  const int dropped = coefficient_fraction + Regressor::fractional_bits - DriftSum::fractional_bits;
  DriftSum sum{};
  for (const std::int32_t coefficient : coefficients) {
    const std::int64_t product = std::int64_t{coefficient} * (regressors++)->raw();
    sum += DriftSum::from_raw(round_shift(product, dropped));
  }
  return sum;
}

}  // namespace fog
