#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

using ActivationInput = Fixed<std::int32_t, 27>;   ///< +-16
using ActivationOutput = Fixed<std::int32_t, 30>;  ///< +-2, used within +-1

/// 1 / (1 + exp(-x)), MATLAB's logsig. Error at most 7e-7 (exhaustive test); monotonic to within
/// it.
ActivationOutput logistic(ActivationInput x);

/// tanh(x), MATLAB's tansig, as 2 logistic(2x) - 1. Error at most 1.4e-6 (exhaustive test).
ActivationOutput hyperbolic_tangent(ActivationInput x);

}  // namespace fog
