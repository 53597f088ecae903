#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

constexpr int kMantissaBits = 23;

/// mantissa * 2^(exponent - 23) as the bits of a normal IEEE 754 single; 2^23 <= mantissa <= 2^24.
constexpr std::uint32_t assemble_float(bool negative, int exponent, std::uint32_t mantissa) {
  constexpr int kExponentBias = 127;
  // Addition, not OR: a mantissa that was rounded up to 2^24 carries into the exponent.
  const std::uint32_t bits =
      (static_cast<std::uint32_t>(exponent + kExponentBias) << kMantissaBits) +
      (mantissa - (1U << kMantissaBits));
  return negative ? bits | 0x80000000U : bits;
}

/// The rate in rad/s as the bits of an IEEE 754 single, computed in integers. Within 1 unit in the
/// last place of the exact value (the product is rounded once, halves away from zero; the constant
/// pi / 648000 has 32 significant bits).
std::uint32_t rate_as_radians_float(Rate rate);

}  // namespace fog
