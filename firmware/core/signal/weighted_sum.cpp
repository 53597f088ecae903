#include "core/signal/weighted_sum.hpp"

#include "core/fixed_point/rounded_product.hpp"

namespace fog {

DriftSum weighted_sum(Span<const std::int32_t> coefficients, const Regressor* regressors,
                      int coefficient_fraction) {
  const int dropped = coefficient_fraction + Regressor::fractional_bits - DriftSum::fractional_bits;
  DriftSum sum{};
  for (const std::int32_t coefficient : coefficients) {
    sum += DriftSum::from_raw(rounded_product(coefficient, (regressors++)->raw(), dropped));
  }
  return sum;
}

}  // namespace fog
