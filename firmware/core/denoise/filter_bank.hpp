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
  /// Newest first: coarser noise in the lower half of a word, what is removed here in the upper.
  std::array<std::uint32_t, kTaps / 2> noise{};
  LevelThreshold threshold;
  std::int16_t waiting_noise = 0;  ///< the odd one of the last pair
};

/// Slots for removed details that wait for the levels below: for every level but the finest, as
/// many as pairs to wait, and one.
constexpr std::size_t denoise_waiting(std::size_t taps, std::size_t levels) {
  std::size_t slots = 0;
  for (std::size_t below = 0; below + 1 < levels; ++below) slots += denoise_delay(taps, below) + 1;
  return slots;
}

/// Any but the finest: it has inputs of its own, and waits for the levels below it.
template <std::size_t kTaps>
struct CoarserLevel : BankLevel<kTaps> {
  std::array<std::int32_t, kTaps + 1> inputs{};  ///< newest first; last, the one without a pair yet
  std::int16_t* removed_first = nullptr;  ///< ring of removed details in memory that somebody else
  std::int16_t* removed_end = nullptr;    ///< owns: as many as pairs to wait, and one
  std::int16_t* removed_next = nullptr;

  /// Takes what is removed now, gives back what was as many pairs ago as it has to wait.
  [[gnu::always_inline]] void hold(std::int32_t removed) {
    *removed_next = static_cast<std::int16_t>(removed);
    removed_next = removed_next + 1 == removed_end ? removed_first : removed_next + 1;
  }
  std::int32_t removed() const { return *removed_next; }
};

/// Memory that a bank works in and that somebody else owns: zeros.
template <std::size_t kTaps>
struct BankMemory {
  std::int32_t* line = nullptr;            ///< SampleLine::memory(delay + 1, kTaps) values
  CoarserLevel<kTaps>* coarser = nullptr;  ///< one less than there are levels
  std::int16_t* waiting = nullptr;         ///< denoise_waiting() slots
};

/// Splits the signal level by level, finds in the details what thresholding would remove, and puts
/// the removed parts together to noise at the rate of the input, late by the delay of the bank.
///
/// Level 1 finds its details as late as they are needed, from the old end of the line of samples
/// that is there anyway, instead of holding them back.
///
/// kTaps: of the filter. An image links the one that it uses.
template <std::size_t kTaps>
class FilterBank {
 public:
  /// `parameters` with kTaps taps, or without levels for a bank that must not be used. Their arrays
  /// and the memory must outlive this.
  FilterBank(const DenoiseParameters& parameters, const BankMemory<kTaps>& memory);

  /// Takes the first sample, as if it had been the input for ever: no noise.
  void prime(std::int32_t sample);

  /// Takes a sample and returns the one of `delay` samples ago without its noise, LSB of Rate.
  /// While the line still holds what prime() put there, prime_further() has to precede each.
  std::int32_t step(std::int32_t sample);
  void prime_further() { line_.fill_further(kTaps); }

  /// Whether the details of level 1 count for the noise gain; at first they do not.
  void follow_noise(bool follow) { follow_noise_ = follow; }

  /// The sample of the last step, for a next one that is missing.
  std::int32_t last() const { return gate_.last(line_); }

  const SampleLine& line() const { return line_; }
  const LevelThreshold& finest_threshold() const { return finest_.threshold; }

 private:
  std::int32_t noise_of_pair(std::uint32_t number);
  [[gnu::cold]] std::int32_t removed_beyond(std::int32_t detail, std::int32_t threshold) const;
  std::int32_t removed(std::int32_t detail, std::uint32_t threshold) const;
  void adapt_finest(std::uint32_t magnitude);
  std::uint32_t adapt_threshold(LevelThreshold& threshold, std::uint32_t magnitude);
  void choose_threshold();

  SampleLine line_;
  OutlierGate gate_;
  std::uint32_t samples_ = 0;  // modulo 2^32
  const std::int32_t* filters_;
  ThresholdRule rule_;
  ThresholdMode mode_;
  int shift_;                   // noise_shift()
  std::int32_t rounding_half_;  // of a shift by shift_
  CoarserLevel<kTaps>* coarser_;
  CoarserLevel<kTaps>* coarser_end_;  // a count would have to be multiplied for each pair
  BankLevel<kTaps> finest_{};
  NoiseScale threshold_scale_;
  bool follow_noise_ = false;
  bool choice_due_ = false;  // some histogram is full
};

}  // namespace fog
