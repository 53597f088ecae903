#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// Angle of rotation during one sample, rad, as the bits of an IEEE 754 single. What the float
/// cannot represent is carried to the next sample: the sum of any number of outputs is within half
/// an LSB of the last one of the integral of the rate.
class DeltaAngle {
 public:
  explicit DeltaAngle(std::uint32_t sample_period_us)
      : per_lsb_(std::uint64_t{sample_period_us} * kAnglePerLsbUs) {}

  /// Adds one sample at `rate`.
  void step(Rate rate);
  /// Output 0: no time has passed, or the rotation is unknown.
  void stand() { bits_ = 0; }

  std::uint32_t bits() const { return bits_; }

  /// 2^-80 rad per microsecond at a rate of 2^-10 deg/h: round(2^80 * pi / 648000e6 / 2^10). The
  /// test DeltaAngle recomputes it.
  static constexpr std::uint64_t kAnglePerLsbUs = 5723669695U;

 private:
  // The longest period and the largest rate: both words of their product, and what a float has left
  // of the step before, which is below 2^(63 - kMantissaBits).
  static_assert(kAnglePerLsbUs <= UINT64_MAX / INT32_MAX);
  static_assert(floor_shift(INT32_MAX * kAnglePerLsbUs, 32) <=
                floor_shift(std::uint64_t{INT64_MAX} - power_of_two<std::uint64_t>(41), 31));

  std::uint64_t per_lsb_;       // 2^-80 rad per sample and LSB of the rate; period below 2^31 us
  std::int64_t angle_ = 0;      // not sent yet, 2^-48 rad; one sample is below 2^62.5
  std::uint32_t fraction_ = 0;  // lower part of it, 2^-80 rad
  std::uint32_t bits_ = 0;
};

}  // namespace fog
