#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/span.hpp"

namespace fog {

/// Drift during summation: 10 bits finer than Rate, to which it is rounded once, at the end.
using DriftSum = Fixed<std::int64_t, 20>;

/// Sum of coefficient * regressor, each product rounded to DriftSum. Not inline: all effects share
/// its code.
///
/// Overflow: |coefficient * regressor| <= 2^62. With at least 10 fractional bits in the
/// coefficients each product loses 18 or more before it is added: the sum of 9 stays below 2^48.
DriftSum weighted_sum(Span<const std::int32_t> coefficients, const Regressor* regressors,
                      int coefficient_fraction);

}  // namespace fog
