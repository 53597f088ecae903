#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// The rate in rad/s as the bits of an IEEE 754 single, made with integers only. Within 1 unit in
/// the last place of the exact value (the product is rounded once, halves away from zero; the
/// constant pi / 648000 has 32 significant bits).
std::uint32_t rate_as_radians_float(Rate rate);

}  // namespace fog
