#pragma once

#include <cstddef>
#include <cstdint>

#include "core/denoise/delay_line.hpp"
#include "core/denoise/denoise_parameters.hpp"

namespace fog {

/// One level of the filter bank: splits its input into a coarser approximation and the details, and
/// turns the noise that was found in the details and below into noise at the rate of its input.
class NoiseLevel {
 public:
  NoiseLevel() = default;
  /// `histories` has 2 values per tap; `delay` holds the noise of the details back for as long as
  /// the levels below take.
  NoiseLevel(Span<const std::int32_t> lowpass, Span<std::int32_t> histories,
             Span<std::int32_t> delay)
      : lowpass_(lowpass),
        inputs_(histories.data),
        coarser_noise_(inputs_ + lowpass.size),
        detail_noise_(coarser_noise_ + lowpass.size / 2),
        detail_delay_(delay) {}

  /// As if `value` had been the input for ever.
  void prime(std::int32_t value);

  /// A new input. Every second one, beginning with the first, completes a pair of outputs.
  void push(std::int32_t input);
  bool completes_pair() const { return even_; }

  /// The new approximation, in the input's format. Bounds: sum |tap| < 2, so the sum stays below
  /// 2^31 * 2^31; what leaves the format is clipped.
  std::int32_t approximation() const;
  /// The new detail, LSB 2^-16, clipped at +-2^15 deg/h.
  std::int32_t detail() const;

  /// Takes the noise in the newest detail and the coarser noise (both LSB 2^-16) and makes the two
  /// noise values of this pair.
  void reconstruct(std::int32_t coarser_noise, std::int32_t detail_noise);
  /// The noise that belongs to the newest input, delayed.
  std::int32_t noise() const { return even_ ? noise_even_ : noise_odd_; }

 private:
  Span<const std::int32_t> lowpass_;
  // Histories, newest first.
  std::int32_t* inputs_ = nullptr;         // one per tap
  std::int32_t* coarser_noise_ = nullptr;  // one per two taps
  std::int32_t* detail_noise_ = nullptr;   // one per two taps
  DelayLine detail_delay_;
  std::int32_t noise_even_ = 0;
  std::int32_t noise_odd_ = 0;
  bool even_ = false;
};

}  // namespace fog
