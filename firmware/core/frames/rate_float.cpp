#include "core/frames/rate_float.hpp"

#include "core/fixed_point/shift.hpp"

namespace fog {
namespace {

// 1 deg/h = pi / 648000 rad/s: round(2^49 * pi / 648000). The test RateFloat recomputes it.
constexpr std::uint64_t kRadiansPerDegreePerHour = 2729258392U;
constexpr int kConstantFraction = 49;
static_assert(kRadiansPerDegreePerHour <= floor_shift(UINT64_MAX, 31));

}  // namespace

std::uint32_t rate_as_radians_float(Rate rate) {
  const std::int64_t raw = rate.raw();
  if (raw == 0) return 0;
  const std::uint64_t magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  // Between 2^31 and 2^63: the top bit is above the mantissa and the number is normal.
  const std::uint64_t product = magnitude * kRadiansPerDegreePerHour;
  const int top_bit = 63 - __builtin_clzll(product);
  const int dropped = top_bit - kMantissaBits;
  const std::uint64_t mantissa = (product + (std::uint64_t{1} << (dropped - 1))) >> dropped;
  return assemble_float(raw < 0, top_bit - kConstantFraction - Rate::fractional_bits,
                        static_cast<std::uint32_t>(mantissa));
}

}  // namespace fog
