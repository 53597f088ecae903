#pragma once

#include <cstddef>
#include <cstdint>

#include "core/fixed_point/shift.hpp"
#include "core/signal/span.hpp"

namespace fog {

enum class ThresholdMode : std::int32_t { soft = 0, hard = 1 };

/// Origin of the thresholds while the board runs (adaptive_thresholds.hpp).
enum class ThresholdRule : std::int32_t {
  fixed = 0,     ///< the table's
  sqtwolog = 1,  ///< the table's times the noise found / the noise expected
  heursure = 2,  ///< likewise, and lower where a level's details contain a strong signal
};

constexpr std::size_t kMaxTaps = 30;            ///< coif5
constexpr std::size_t kAnyTaps = kMaxTaps + 1;  ///< as a template argument: chosen at run time
constexpr std::size_t kOrNone = 64;  ///< added to a number of taps: or without a denoiser

/// Bit n: filters of 2 n taps. Bit 0: no denoiser.
using FilterMask = std::uint32_t;
/// The filters that a denoiser compiled for `taps` taps can use.
constexpr FilterMask filters_of(std::size_t taps) {
  if (taps == kAnyTaps) return ~FilterMask{0};
  const FilterMask one = FilterMask{1} << (taps % kOrNone / 2);
  return taps > kOrNone ? one | 1U : one;
}

constexpr std::size_t kMaxLevels = 10;
constexpr int kTapFraction = 31;           ///< of analysis taps
constexpr int kSynthesisTapFraction = 15;  ///< of synthesis taps
constexpr int kDetailFraction = 16;        ///< details and thresholds, deg/h

/// Largest sum of the magnitudes of analysis taps: below 2. With it no sum over the taps leaves 64
/// bits, whatever the samples; a detail's, in two parts, begins with a smaller half.
constexpr std::int64_t kMaxTapSum = 2 * power_of_two<std::int64_t>(kTapFraction) - 2;
static_assert(kMaxTapSum <= floor_shift(INT64_MAX - rounding_half<std::int64_t>(kTapFraction), 31));

/// A wavelet filter and its thresholds; level 1 is the finest. Without levels: no denoising, no
/// delay. All taps are divided by sqrt 2, so that the low-pass filter sums to 1. `taps` is even.
struct DenoiseParameters {
  /// Two arrays of `taps` words, one after the other.
  ///   low:        2^31 * tap of the decomposition filter; low[i] multiplies the i-th sample
  ///               before the newest. Even and odd taps sum to 2^30 each, so that a constant
  ///               passes exactly.
  ///   synthesis:  both filters reversed, 2^15 * tap, two per word: low[taps - 1 - i] in the
  ///               lower half of word i, high[taps - 1 - i] in the upper half, where high[i] =
  ///               (-1)^i low[taps - 1 - i].
  Span<const std::int32_t> filters;
  Span<const std::int32_t> thresholds;  ///< one per level, LSB 2^-16 deg/h, not negative
  ThresholdRule rule = ThresholdRule::fixed;
  ThresholdMode mode = ThresholdMode::soft;

  std::size_t taps() const { return filters.size / 2; }
  Span<const std::int32_t> low() const { return {filters.data, taps()}; }
  Span<const std::int32_t> synthesis() const { return {filters.data + taps(), taps()}; }
  std::size_t levels() const { return thresholds.size; }
};

/// Delay of a filter bank with `levels` levels, in samples at its input.
constexpr std::size_t denoise_delay(std::size_t taps, std::size_t levels) {
  return (taps - 1) * ((std::size_t{1} << levels) - 1);
}

/// Largest ratio of an adaptive threshold to the table's.
constexpr std::uint32_t kMaxThresholdScale = 4;

/// Noise within the bank has 16 bits, LSB 2^(shift - 16) deg/h. Returns the smallest shift with
/// which no sum of removed details can overflow, whatever the input; -1 if even kMaxNoiseShift is
/// too small (thresholds of thousands of deg/h).
constexpr int kMaxNoiseShift = 15;
constexpr std::uint32_t kMaxNoise = INT16_MAX;  ///< and the largest removed detail, shifted
constexpr std::uint32_t kMaxRemoved =
    kMaxNoise * power_of_two<std::uint32_t>(kMaxNoiseShift);  ///< threshold that passes, adapted
int noise_shift(const DenoiseParameters& parameters);

}  // namespace fog
