#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/fixed_point/shift.hpp"

namespace fog {

/// Number of details on which each choice of a level's threshold is based.
constexpr std::uint32_t kThresholdBlock = 128;

/// Noise as a multiple of the value that the model table expects: a running median of the magnitude
/// of the finest details. Outliers and rotation hardly change it.
class NoiseScale {
 public:
  static constexpr int kFraction = 16;
  static constexpr std::uint32_t kMax =
      4 * power_of_two<std::uint32_t>(kFraction);  ///< kMaxThresholdScale

  /// Universal threshold of a level for which the table expects `expected_universal`; below 2^30.
  std::uint32_t of(std::uint32_t expected_universal) const {
    return static_cast<std::uint32_t>(
        floor_shift(std::uint64_t{expected_universal} * threshold_scale_, kFraction));
  }

  /// Running median: each detail moves the estimate by 1/512 towards itself. In white noise its
  /// error is 3.4 % rms; after a jump of the noise it covers half of the change in 350 details.
  /// `expected_universal`: universal threshold of the finest level at threshold scale 1.
  [[gnu::always_inline]] void follow(std::uint32_t magnitude, std::uint32_t expected_universal) {
    const std::uint32_t step = floor_shift(threshold_scale_, kStepShift);
    const auto median = static_cast<std::uint32_t>(
        floor_shift(std::uint64_t{of(expected_universal)} * kMedianShare, kShareFraction));
    if (magnitude > median) {
      threshold_scale_ += step;
      if (threshold_scale_ > kMax) threshold_scale_ = kMax;
    } else if (threshold_scale_ > kMin) {
      threshold_scale_ -= step;
    }
  }

 private:
  static constexpr int kStepShift = 9;
  static constexpr auto kMin =
      power_of_two<std::uint32_t>(kStepShift);  // 1/128: below it a step would be 0
  // Median of the magnitude of white noise / its universal threshold: 0.6745 / sqrt(2 ln 128).
  static constexpr int kShareFraction = 32;
  static constexpr std::uint32_t kMedianShare = 887 * power_of_two<std::uint32_t>(20);

  std::uint32_t threshold_scale_ = power_of_two<std::uint32_t>(kFraction);
};

/// Chooses one level's threshold by Stein's unbiased risk estimate (SURE) over blocks of its latest
/// details. add() takes a few instructions, choose() about 200.
class RiskHistogram {
 public:
  static constexpr std::uint32_t kWhole = 16;

  static constexpr std::uint32_t kMaxUniversal = INT16_MAX;

  /// Counts a detail: its magnitude and the universal threshold of its level, in the same unit; the
  /// threshold up to kMaxUniversal.
  [[gnu::always_inline]] void add(std::uint32_t magnitude, std::uint32_t universal) {
    if (universal == 0) return;
    const bool large = magnitude >= kMaxScaled / kUnits * universal;
    const std::uint32_t scaled = large ? kMaxScaled : magnitude * kUnits / universal;
    const std::uint32_t bin = scaled / kUnitsPerBin;
    if (bin < kWhole) ++counts_[bin];
    energy_ =
        static_cast<std::uint16_t>(energy_ + (scaled * scaled + kEnergyUnit / 2) / kEnergyUnit);
    ++details_;
  }
  bool full() const { return details_ >= kThresholdBlock; }

  /// If the block is full, sets the threshold, starts a new block and returns true. The threshold
  /// is the universal one if the signal is weak, else the candidate with the smallest risk.
  bool choose();

  /// Threshold of the level in sixteenths of the universal one, 1 to kWhole.
  std::uint32_t sixteenths() const { return kWhole - reduction_; }

 private:
  static constexpr std::uint32_t kUnits = 64;  // per universal threshold
  static constexpr std::uint32_t kUnitsPerBin = kUnits / kWhole;
  static constexpr std::uint32_t kMaxScaled = 256;
  static constexpr std::uint32_t kEnergyUnit = 256;
  // add(): the detail before it is divided; then the sum of as many as can be counted.
  static_assert(kMaxUniversal <= UINT32_MAX / kMaxScaled);
  static_assert(UINT8_MAX * (kMaxScaled * kMaxScaled / kEnergyUnit) <= UINT16_MAX);
  static_assert(kThresholdBlock <= UINT8_MAX);

  std::uint32_t min_risk() const;

  std::uint16_t energy_ = 0;  // sum of squares / kEnergyUnit, at most 128 * 256
  std::array<std::uint8_t, kWhole> counts_{};
  std::uint8_t details_ = 0;
  std::uint8_t reduction_ = 0;  // sixteenths
};

/// Threshold of one level.
struct LevelThreshold {
  std::uint32_t expected = 0;  ///< the table's, LSB 2^-16 deg/h
  std::uint32_t now = 0;       ///< at most kMaxThresholdScale times as much
  RiskHistogram risk;          ///< heursure only
};

}  // namespace fog
