#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/denoise/adaptive_thresholds.hpp"
#include "core/denoise/denoise_parameters.hpp"
#include "core/denoise/outlier_gate.hpp"
#include "core/denoise/sample_line.hpp"

namespace fog {

/// One level of the bank.
template <std::size_t kTaps>
struct BankLevel {
  /// Newest first: coarser noise in the lower half of a word, removed detail in the upper half.
  std::array<std::uint32_t, kTaps / 2> noise{};
  LevelThreshold threshold;
  std::int16_t waiting_noise = 0;  ///< second value of the last pair
};

/// Slots for removed details that wait for coarser levels: for every level but the finest, the
/// pairs to wait plus one.
constexpr std::size_t denoise_waiting(std::size_t taps, std::size_t levels) {
  std::size_t slots = 0;
  for (std::size_t below = 0; below + 1 < levels; ++below) slots += denoise_delay(taps, below) + 1;
  return slots;
}

/// Any level but the finest: it stores its own inputs, and its removed details wait for the coarser
/// levels.
template <std::size_t kTaps>
struct CoarserLevel : BankLevel<kTaps> {
  /// Newest first. While the second of a pair is due, the place of the first is not in use.
  std::array<std::int32_t, kTaps> inputs{};
  std::int16_t* removed_first = nullptr;  ///< ring of removed details in memory that somebody else
  std::int16_t* removed_end = nullptr;    ///< owns: as many as pairs to wait, and one
  std::int16_t* removed_next = nullptr;

  /// Stores `removed` and releases the value stored as many pairs ago as the level has to wait.
  [[gnu::always_inline]] void hold(std::int32_t removed) {
    *removed_next = static_cast<std::int16_t>(removed);
    removed_next = removed_next + 1 == removed_end ? removed_first : removed_next + 1;
  }
  std::int32_t removed() const { return *removed_next; }
};

/// Decomposes the signal level by level, finds in the details what thresholding removes, and
/// synthesises the removed parts to noise at the input's sample rate, delayed by the bank.
///
/// Level 1 needs no memory for waiting details: it computes them as late as they are needed, from
/// the old end of the sample line.
///
/// kTaps: taps of the filter. An image links only its own length.
template <std::size_t kTaps>
class FilterBank {
 public:
  /// `parameters` has kTaps taps, or no levels for a bank that must not be used. `line`:
  /// SampleLine::memory(delay + 1, kTaps) values; `coarser`: one level less than the parameters'.
  /// All arrays must outlive this object.
  FilterBank(const DenoiseParameters& parameters, std::int32_t* line, CoarserLevel<kTaps>* coarser);

  /// To be called once, when all memory is zero, with the same parameters and denoise_waiting()
  /// slots.
  void start(const DenoiseParameters& parameters, std::int16_t* slots);

  /// Takes the first sample as if it had been the input for ever: no noise.
  void prime(std::int32_t sample);

  /// Takes a sample; returns the one of `delay` samples ago without its noise, LSB of Rate. As long
  /// as the line is being filled, prime_further() has to be called before each step.
  std::int32_t step(std::int32_t sample);
  void prime_further() { line_.fill_further(kTaps); }

  /// Whether the details of level 1 update the noise scale; initially they do not.
  void follow_noise(bool follow) { follow_noise_ = follow; }

  /// Sample of the last step: substitute for a missing one.
  std::int32_t last() const { return gate_.last(line_); }

  const SampleLine& line() const { return line_; }
  OutlierGate& gate() { return gate_; }
  const LevelThreshold& finest_threshold() const { return finest_.threshold; }

 private:
  std::int32_t noise_of_pair(std::uint32_t number);
  std::int32_t removed(std::int32_t detail, std::uint32_t threshold) const;
  void adapt_finest(std::uint32_t magnitude);
  std::uint32_t adapt_threshold(LevelThreshold& threshold, std::uint32_t magnitude);
  void choose_threshold();

  SampleLine line_;
  OutlierGate gate_;
  std::uint32_t samples_ = 0;  // modulo 2^32
  const std::int32_t* filters_;
  ThresholdRule rule_;
  std::uint32_t clipped_;       // what is removed beyond a threshold: all bits of it, or none
  int shift_;                   // noise_shift()
  std::int32_t rounding_half_;  // half of 2^shift_
  CoarserLevel<kTaps>* coarser_;
  CoarserLevel<kTaps>*
      coarser_end_;  // a pointer, because a count would be multiplied for each pair
  BankLevel<kTaps> finest_{};
  NoiseScale threshold_scale_;
  bool follow_noise_ = false;
  bool choice_due_ = false;  // some histogram is full
};

}  // namespace fog
