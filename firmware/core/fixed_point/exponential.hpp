#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

/// exp(-x) for x from 0 to 32; 1 for x below 0. Error at most 1.54e-9; monotonic
/// (bench/core_functions: all arguments).
Fixed<std::int32_t, 30> exponential_decay(Fixed<std::int32_t, 26> x);

}  // namespace fog
