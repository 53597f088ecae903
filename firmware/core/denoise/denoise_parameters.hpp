#pragma once

#include <cstddef>
#include <cstdint>

#include "core/signal/span.hpp"

namespace fog {

enum class ThresholdMode : std::int32_t { soft = 0, hard = 1 };

constexpr std::size_t kMostTaps = 30;  ///< coif5
constexpr std::size_t kMostLevels = 10;
constexpr int kTapFraction = 30;
constexpr int kDetailFraction = 16;  ///< details and thresholds, deg/h

/// A wavelet filter and its thresholds. Level 1 is the finest. No levels: no denoising, no delay.
struct DenoiseParameters {
  /// Decomposition low-pass filter divided by sqrt 2, so that its taps sum to 1: 2^30 * tap. The
  /// number of taps is even, and even and odd taps sum to 2^29 each, so a constant passes exactly.
  Span<const std::int32_t> lowpass;
  Span<const std::int32_t> thresholds;  ///< one per level, LSB 2^-16 deg/h, not negative
  ThresholdMode mode = ThresholdMode::soft;

  std::size_t levels() const { return thresholds.size; }
};

/// Delay of one level's filters and everything below it, in samples at that level's input.
constexpr std::size_t denoise_delay(std::size_t taps, std::size_t levels) {
  return levels == 0 ? 0 : (taps - 1) * ((std::size_t{1} << levels) - 1);
}

}  // namespace fog
