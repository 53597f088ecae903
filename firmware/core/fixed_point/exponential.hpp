#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"

namespace fog {

/// exp(-x) for x from 0 to 32; 1 for x below 0. Error at most 3e-9; monotonic (test: sweep of the
/// range).
Fixed<std::int32_t, 30> exponential_decay(Fixed<std::int32_t, 26> x);

}  // namespace fog
