#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/denoise/filter_bank.hpp"
#include "core/denoise/sample_line.hpp"
#include "core/denoise/validity_line.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Samples held: the delay and the newest one.
constexpr std::size_t denoise_line_length(std::size_t taps, std::size_t levels) {
  return denoise_delay(taps, levels) + 1;
}

struct DenoiserOutput {
  Rate rate{};
  bool valid = false;  ///< whether the sample that it stands for was
};

/// Streaming wavelet denoiser: one sample in, one sample out, late by delay() samples.
///
/// It does not rebuild the signal from shrunken wavelet coefficients. It rebuilds what the
/// shrinking took away (of a soft threshold t: the detail clipped to +-t) and subtracts that from
/// the delayed input. For exact arithmetic the two are the same, because the filter bank
/// reconstructs perfectly. In integers this form is the better one: with thresholds 0 the output is
/// the delayed input, bit for bit; a rotation of any size passes with an error bounded by the
/// thresholds, not by its size; full-scale input needs no head room; and noise is small, so that 16
/// bits hold it. SPEC.md beside this file says it all.
template <std::size_t kTaps, std::size_t kLevels>
class Denoiser {
  static_assert(kTaps % 2 == 0, "include core/denoise/any_denoiser.hpp for kAnyTaps");

 public:
  /// Needs levels <= kLevels and exactly kTaps taps (read_model checks). Without levels, as a model
  /// that is refused leaves them, no sample may be valid.
  explicit Denoiser(const DenoiseParameters& parameters)
      : filling_(denoise_line_length(kTaps, parameters.levels())),
        bank_(parameters, {memory_.line.data(), memory_.coarser.data(), memory_.waiting.data()}) {
    memory_.validity.unsettle(filling_ - 1);  // all but the first
  }
  // The parts point into this.
  Denoiser(const Denoiser&) = delete;
  Denoiser& operator=(const Denoiser&) = delete;

  /// The first valid sample primes all lines: from then on it is as if that rate had been there for
  /// ever, and it is what comes out until the line is full. In place of a sample that is not valid
  /// the last valid one is taken, so that a fault spoils no other sample.
  DenoiserOutput step(Rate rate, bool valid) {
    if (!valid || !memory_.validity.settled()) return unsettled_step(rate, valid);
    return {Rate::from_raw(bank_.step(rate.raw())), true};
  }

  /// Whether the last output still stood for a time before the first sample.
  bool filling() const { return filling_ > 0; }

  std::size_t delay() const { return bank_.line().length() - 1; }

 private:
  static constexpr std::size_t kLine = denoise_line_length(kTaps, kLevels);

  struct Memory {
    ValidityLine<kLine> validity;
    std::array<CoarserLevel<kTaps>, kLevels - 1> coarser;
    std::array<std::int32_t, SampleLine::memory(kLine, kTaps)> line;
    std::array<std::int16_t, denoise_waiting(kTaps, kLevels)> waiting;
  };

  // At start-up and around samples that are not valid.
  [[gnu::noinline]] DenoiserOutput unsettled_step(Rate rate, bool valid) {
    const std::size_t length = bank_.line().length();
    if (filling_ == length) {  // nothing valid yet
      if (!valid) return {};
      bank_.prime(rate.raw());
      --filling_;
      return {rate, true};
    }
    if (filling_ > 0) {
      --filling_;
      bank_.prime_further();
    }
    if (!valid) rate = Rate::from_raw(bank_.last());
    bank_.follow_noise(false);
    rate = Rate::from_raw(bank_.step(rate.raw()));
    bank_.follow_noise(true);
    return {rate, memory_.validity.exchange(valid, length)};
  }

  std::size_t filling_;  // samples until the line is full
  Memory memory_{};
  FilterBank<kTaps> bank_;
};

/// No levels: no delay. In place of a sample that is not valid, the last valid one.
template <std::size_t kTaps>
class Denoiser<kTaps, 0> {
 public:
  explicit Denoiser(const DenoiseParameters& /*none*/) {}

  DenoiserOutput step(Rate rate, bool valid) {
    if (valid) {
      filling_ = false;
      last_valid_ = rate;
    }
    return {last_valid_, valid};
  }
  bool filling() const { return filling_; }
  std::size_t delay() const { return 0; }

 private:
  bool filling_ = true;
  Rate last_valid_{};
};

}  // namespace fog
