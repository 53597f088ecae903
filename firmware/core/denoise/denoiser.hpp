#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/denoise/filter_bank.hpp"
#include "core/denoise/sample_line.hpp"
#include "core/denoise/validity_line.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// Samples stored: the delay and the newest one.
constexpr std::size_t denoise_line_length(std::size_t taps, std::size_t levels) {
  return denoise_delay(taps, levels) + 1;
}

struct DenoiserOutput {
  Rate rate{};
  bool valid = false;  ///< whether the sample of this output was valid, and no outlier
};

/// Streaming wavelet denoiser: one sample in, one sample out, late by delay() samples.
///
/// It does not reconstruct the signal from shrunken wavelet coefficients. It reconstructs what the
/// shrinkage removes (with a soft threshold t: the detail clipped to +-t) and subtracts that from
/// the delayed input. In exact arithmetic the two are equal, because the filter bank reconstructs
/// perfectly. In integers this form is better: with thresholds 0 the output equals the delayed
/// input bit for bit; the error of a rotation of any size is bounded by the thresholds; full-scale
/// input needs no headroom; and the removed noise fits 16 bits. firmware/spec/denoiser.md has the
/// details.
template <std::size_t kTaps, std::size_t kLevels>
class Denoiser {
  static_assert(kTaps % 2 == 0, "include core/denoise/any_denoiser.hpp for kAnyTaps");

 public:
  /// Needs levels <= kLevels and exactly kTaps taps (read_model checks both). Without levels, as
  /// after a refused model, no sample may be passed as valid.
  explicit Denoiser(const DenoiseParameters& parameters)
      : filling_(denoise_line_length(kTaps, parameters.levels())),
        bank_(parameters, line_in(memory_), coarser_in(memory_)) {
    bank_.start(parameters, memory_.waiting.data());
    bank_.gate().watch(filling_ - 1);  // all but the first
  }
  // Not copyable: its parts refer to its memory.
  Denoiser(const Denoiser&) = delete;
  Denoiser& operator=(const Denoiser&) = delete;

  /// The first valid sample fills all lines, as if it had been the input for ever, and is the
  /// output until the line is full. A sample that is not valid is replaced by the last valid one,
  /// so that a fault disturbs no other sample. An outlier that the gate has removed may have been a
  /// rotation: its output is not valid either.
  DenoiserOutput step(Rate rate, bool valid) {
    if (!valid || bank_.gate().watched()) return unsettled_step(rate, valid);
    return {Rate::from_raw(bank_.step(rate.raw())), true};
  }

  /// Whether the last output was for a time before the first sample.
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

  // Places that the bank looks into from its start() on, when the memory is zero.
  static std::int32_t* line_in(Memory& memory) { return memory.line.data(); }
  static CoarserLevel<kTaps>* coarser_in(Memory& memory) { return memory.coarser.data(); }

  // At start-up and around samples that are invalid or withheld. Whether a sample was an outlier
  // shows with the next one: so validities are stored one sample late.
  [[gnu::noinline]] DenoiserOutput unsettled_step(Rate rate, bool valid) {
    const std::size_t length = bank_.line().length();
    OutlierGate& gate = bank_.gate();
    if (filling_ == length) {  // no valid sample yet
      if (!valid) return {};
      bank_.prime(rate.raw());
      --filling_;
      return {rate, true};
    }
    if (filling_ > 0) {
      --filling_;
      bank_.prime_further();
    }
    gate.count_watched();
    if (!valid) rate = Rate::from_raw(bank_.last());
    rate = Rate::from_raw(bank_.step(rate.raw()));
    const bool last_valid = gate.valid();
    gate.set_valid(valid);
    if (!(valid & last_valid)) gate.watch(length);
    const bool oldest_valid = oldest_after(last_valid, length);
    bank_.follow_noise(oldest_valid & (filling_ == 0));
    return {rate, oldest_valid};
  }

  // Validity of the oldest of `length` samples, after that of the last but one.
  bool oldest_after(bool last_but_one, std::size_t length) {
    constexpr std::size_t kOtherPlaces = 2;  // the newest, and the oldest itself
    if constexpr (kTaps == 2) {
      if (length == kOtherPlaces) return last_but_one;
    }
    return memory_.validity.exchange(last_but_one, length - kOtherPlaces);
  }

  std::size_t filling_;     // samples left until the line is full
  FilterBank<kTaps> bank_;  // before its memory, because its members are reached in less code there
  Memory memory_{};
};

/// Without levels there is no delay; an invalid sample is replaced by the last valid one.
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
