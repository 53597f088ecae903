#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"

namespace fog {

/// The angle that a rate makes in a sample, in rad, as the bits of an IEEE 754 single. What a float
/// cannot hold of it is part of the next sample's: the sum of all of them is within half an LSB of
/// the last one of the integral of the rate, however many they are.
class DeltaAngle {
 public:
  explicit DeltaAngle(std::uint32_t sample_period_us)
      : per_lsb_(std::uint64_t{sample_period_us} * kAnglePerLsbUs) {}

  /// A sample more at this rate.
  void step(Rate rate);
  /// Nothing has turned: time stands, or nobody knows.
  void stand() { bits_ = 0; }

  std::uint32_t bits() const { return bits_; }

  /// A rate of 2^-10 deg/h makes in a microsecond so many times 2^-80 rad: round(2^80 * pi /
  /// 648000e6 / 2^10). The test DeltaAngle recomputes it.
  static constexpr std::uint64_t kAnglePerLsbUs = 5723669695U;

 private:
  std::uint64_t per_lsb_;       // 2^-80 rad for each LSB of the rate: period below 2^31 us
  std::int64_t angle_ = 0;      // not sent yet, 2^-48 rad: of one sample below 2^62.5
  std::uint32_t fraction_ = 0;  // of that, 2^-80 rad
  std::uint32_t bits_ = 0;
};

}  // namespace fog
