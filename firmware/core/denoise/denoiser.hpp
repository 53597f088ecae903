#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/denoise/filter_bank.hpp"
#include "core/denoise/sample_line.hpp"
#include "core/denoise/validity_line.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Samples held: the delay, the newest one, and never fewer than the outlier gate looks at.
constexpr std::size_t denoise_line_length(std::size_t taps, std::size_t levels) {
  const std::size_t length = denoise_delay(taps, levels) + 1;
  return length < 3 ? 3 : length;
}

/// Removed details of all levels but the first that wait for the levels below.
constexpr std::size_t denoise_waiting(std::size_t taps, std::size_t levels) {
  std::size_t details = 0;
  for (std::size_t level = 1; level < levels; ++level) {
    details += denoise_delay(taps, levels - 1 - level);
  }
  return details;
}

/// Words for the line of samples and the windows of the filters.
constexpr std::size_t denoise_words(std::size_t taps, std::size_t levels) {
  if (levels == 0) return 0;
  return SampleLine::memory(denoise_line_length(taps, levels), taps) + (levels - 1) * taps +
         levels * (taps / 2);
}

/// Streaming wavelet denoiser: one sample in, one sample out, late by delay() samples.
///
/// It does not rebuild the signal from shrunken wavelet coefficients. It rebuilds what the
/// shrinking took away (of a soft threshold t: the detail clipped to +-t) and subtracts that from
/// the delayed input. For exact arithmetic the two are the same, because the filter bank
/// reconstructs perfectly. In integers this form is the better one: with thresholds 0 the output is
/// the delayed input, bit for bit; a rotation of any size passes with an error bounded by the
/// thresholds, not by its size; full-scale input needs no head room; and noise is small, so that 16
/// bits hold it. README.md beside this file says it all.
template <std::size_t kTaps, std::size_t kLevels>
class Denoiser {
 public:
  /// Needs levels <= kLevels and exactly kTaps taps, or any for kAnyTaps (read_model checks).
  explicit Denoiser(const DenoiseParameters& parameters)
      : delay_(denoise_delay(parameters.taps(), parameters.levels())), filling_(delay_ + 1) {
    if (parameters.levels() == 0) return;
    if constexpr (kLevels > 0) set_up(parameters);
  }
  // The parts point into this.
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
    if (!valid || filling_ > 0 || delay_ == 0 || !validity_.settled()) {
      return unsettled_step(rate, valid);
    }
    last_valid_ = rate;
    return {denoised(rate, true), true};
  }

  /// Whether the last output still stood for a time before the first sample.
  bool filling() const { return filling_ > 0; }

  std::size_t delay() const { return delay_; }

 private:
  static constexpr std::size_t kRoomForTaps = kTaps == kAnyTaps ? kMostTaps : kTaps;

  void set_up(const DenoiseParameters& parameters) {
    const std::size_t taps = parameters.taps();
    const std::size_t levels = parameters.levels();
    std::int32_t* words = words_.data();
    const auto take = [&words](std::size_t count) { return (words += count) - count; };
    const std::size_t length = denoise_line_length(taps, levels);
    const std::size_t line_words = SampleLine::memory(length, taps);
    BankMemory memory;
    memory.line = SampleLine({take(line_words), line_words}, length);
    memory.levels = {levels_.data(), levels};
    memory.inputs = take((levels - 1) * taps);
    memory.noise_windows = reinterpret_cast<std::uint32_t*>(take(levels * (taps / 2)));
    std::int16_t* waiting = waiting_.data();
    for (std::size_t i = 0; i < levels; ++i) {
      const std::size_t pairs = i == 0 ? 0 : denoise_delay(taps, levels - 1 - i);
      levels_[i].removed_delay = waiting;
      levels_[i].delay_length = static_cast<std::uint16_t>(pairs);
      waiting += pairs;
    }
    bank_ = FilterBank(parameters, memory);
  }

  // At start-up, without levels, and around samples that are not valid.
  [[gnu::noinline]] Output unsettled_step(Rate rate, bool valid) {
    if (valid) {
      if (!primed_) prime(rate);
      last_valid_ = rate;
    }
    if (!primed_) return {};
    if (filling_ > 0) --filling_;
    if (delay_ == 0) return {last_valid_, valid};
    const Rate output = denoised(last_valid_, false);
    if (valid && validity_.settled()) return {output, true};
    return {output,
            validity_.exchange(valid, bank_.newest_slot(), bank_.oldest_slot(), bank_.slots())};
  }

  Rate denoised(Rate rate, bool adapt) {
    if constexpr (kLevels > 0) {
      return Rate::from_raw(bank_.step<kTaps>(rate.raw(), adapt));
    } else {
      return rate;
    }
  }

  void prime(Rate rate) {
    primed_ = true;
    if (delay_ > 0) bank_.prime(rate.raw());
  }

  std::size_t delay_;
  std::size_t filling_;  // samples until the line is full
  bool primed_ = false;
  Rate last_valid_{};
  ValidityLine<denoise_line_length(kRoomForTaps, kLevels)> validity_;
  FilterBank bank_;
  std::array<BankLevel, kLevels> levels_{};
  std::array<std::int32_t, denoise_words(kRoomForTaps, kLevels)> words_{};
  std::array<std::int16_t, denoise_waiting(kRoomForTaps, kLevels)> waiting_{};
};

}  // namespace fog
