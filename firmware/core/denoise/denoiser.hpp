#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/denoise/bit_delay_line.hpp"
#include "core/denoise/delay_line.hpp"
#include "core/denoise/denoise_parameters.hpp"
#include "core/denoise/noise_level.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Values of memory that a denoiser needs: its delay lines and filter histories.
constexpr std::size_t denoise_memory(std::size_t taps, std::size_t levels) {
  std::size_t values = denoise_delay(taps, levels) + levels * 2 * taps;
  for (std::size_t level = 1; level < levels; ++level) {
    values += denoise_delay(taps, levels - level);
  }
  return values;
}

/// Streaming wavelet denoiser: one sample in, one sample out, late by delay() samples.
///
/// It does not rebuild the signal from shrunken wavelet coefficients. It rebuilds what the
/// shrinking took away (of a soft threshold t: the detail clipped to +-t) and subtracts that from
/// the delayed input. For exact arithmetic the two are the same, because the filter bank
/// reconstructs perfectly. In integers this form is the better one: with thresholds 0 the output is
/// the delayed input, bit for bit; a rotation of any size passes with an error bounded by the
/// thresholds, not by its size; and full-scale input needs no head room. The filters:
/// noise_level.cpp.
template <std::size_t kTaps, std::size_t kLevels>
class Denoiser {
 public:
  /// Needs taps <= kTaps and levels <= kLevels (ModelParameters::read checks).
  explicit Denoiser(const DenoiseParameters& parameters)
      : parameters_(parameters),
        delay_(denoise_delay(parameters.lowpass.size, parameters.levels())) {
    Span<std::int32_t> memory{memory_.data(), memory_.size()};
    const auto take = [&memory](std::size_t size) {
      const Span<std::int32_t> taken{memory.data, size};
      memory = {memory.data + size, memory.size - size};
      return taken;
    };
    const std::size_t taps = parameters.lowpass.size;
    input_delay_ = DelayLine(take(delay_));
    validity_delay_.set_length(delay_);
    for (std::size_t i = 0; i < parameters.levels(); ++i) {
      const auto histories = take(2 * taps);
      levels_[i] = NoiseLevel(parameters.lowpass, histories,
                              take(denoise_delay(taps, parameters.levels() - 1 - i)));
    }
  }
  // The delay lines point into memory_.
  Denoiser(const Denoiser&) = delete;
  Denoiser& operator=(const Denoiser&) = delete;

  struct Output {
    Rate rate{};
    bool valid = false;  ///< whether the sample that it stands for was
  };

  /// The first valid sample primes all lines: from then on it is as if that rate had been there for
  /// ever, and it is what comes out until the line is full. In place of a sample that is not valid
  /// the last valid one is taken, so that a fault spoils no other sample.
  Output step(Rate rate, bool valid) {
    if (valid) {
      last_valid_ = rate;
      if (!primed_) prime(rate);
    }
    if (!primed_) return {};
    if (samples_ <= delay_) ++samples_;
    const std::int32_t input = last_valid_.raw();
    const auto removed = Fixed<std::int64_t, kDetailFraction>::from_raw(noise_of(input));
    using Wide = Fixed<std::int64_t, Rate::fractional_bits>;
    const auto delayed = Wide::from_raw(input_delay_.exchange(input));
    return {saturate_to<Rate>(delayed - round_to<Wide>(removed)), validity_delay_.exchange(valid)};
  }

  /// Whether the last output still stood for a time before the first sample.
  bool filling() const { return samples_ <= delay_; }

  std::size_t delay() const { return delay_; }

 private:
  void prime(Rate rate) {
    primed_ = true;
    input_delay_.fill(rate.raw());
    for (std::size_t i = 0; i < parameters_.levels(); ++i) levels_[i].prime(rate.raw());
  }

  // Down the levels as far as pairs complete, then back up with the noise.
  std::int32_t noise_of(std::int32_t input) {
    const std::size_t levels = parameters_.levels();
    if (levels == 0) return 0;
    std::size_t deepest = 0;
    levels_[0].push(input);
    while (levels_[deepest].completes_pair() && deepest + 1 < levels) {
      levels_[deepest + 1].push(levels_[deepest].approximation());
      ++deepest;
    }
    // The deepest level that was fed either completed its pair (it is the last one, with nothing
    // coarser) or has its second value ready.
    if (levels_[deepest].completes_pair()) {
      levels_[deepest].reconstruct(0, removed(deepest));
    }
    while (deepest > 0) {
      const std::int32_t coarser = levels_[deepest].noise();
      --deepest;
      levels_[deepest].reconstruct(coarser, removed(deepest));
    }
    return levels_[0].noise();
  }

  // What thresholding takes away from the newest detail of a level.
  std::int32_t removed(std::size_t level) const {
    const std::int32_t threshold = parameters_.thresholds[level];
    const std::int32_t detail = levels_[level].detail();
    const bool inside = detail <= threshold && detail >= -threshold;
    if (inside) return detail;
    if (parameters_.mode == ThresholdMode::hard) return 0;
    return detail > 0 ? threshold : -threshold;
  }

  DenoiseParameters parameters_;
  std::size_t delay_;
  std::size_t samples_ = 0;  // counts up to delay_ + 1
  bool primed_ = false;
  Rate last_valid_{};
  DelayLine input_delay_;
  BitDelayLine<denoise_delay(kTaps, kLevels)> validity_delay_;
  std::array<NoiseLevel, kLevels> levels_{};
  std::array<std::int32_t, denoise_memory(kTaps, kLevels)> memory_{};
};

}  // namespace fog
