#pragma once

#include <cstddef>
#include <cstdint>

#include "core/denoise/adaptive_thresholds.hpp"
#include "core/denoise/denoise_parameters.hpp"
#include "core/denoise/outlier_gate.hpp"
#include "core/denoise/sample_line.hpp"

namespace fog {

/// One level of the bank: its state, in memory that the denoiser owns.
struct BankLevel {
  std::int16_t* removed_delay = nullptr;  ///< holds removed details back for the levels below
  std::uint16_t delay_length = 0;         ///< of removed_delay
  std::uint16_t delay_next = 0;           ///< its oldest
  std::uint32_t threshold = 0;            ///< now, LSB 2^-16 deg/h
  std::int32_t waiting_input = 0;         ///< the older one of the next pair
  std::int16_t waiting_noise = 0;         ///< the odd one of the last pair
  RiskHistogram risk;                     ///< heursure only
};

/// Memory that a bank works in and that somebody else owns.
struct BankMemory {
  SampleLine line;                         ///< delay + 1 samples or more
  Span<BankLevel> levels;                  ///< each with its removed_delay
  std::int32_t* inputs = nullptr;          ///< levels - 1 windows of as many samples as taps
  std::uint32_t* noise_windows = nullptr;  ///< levels windows of half as many words
};

/// Splits the signal level by level, finds in the details what thresholding would remove, and puts
/// the removed parts together to noise at the rate of the input, late by the delay of the bank.
///
/// Level 1 finds its details as late as they are needed, from the old end of the line of samples
/// that is there anyway, instead of holding them back.
class FilterBank {
 public:
  FilterBank() = default;
  /// `parameters` with at least one level; their arrays and the memory must outlive this.
  FilterBank(const DenoiseParameters& parameters, const BankMemory& memory);

  /// As if `value` had been the input for ever: no noise.
  void prime(std::int32_t value);

  /// Takes a sample and returns the one of `delay` samples ago without its noise, LSB of Rate.
  /// Where `adapt`, the late details of level 1 count for the noise gain. kTaps is the number of
  /// taps, or kAnyTaps; an image links the one that it uses.
  template <std::size_t kTaps>
  std::int32_t step(std::int32_t sample, bool adapt);

  /// Slots of the line; where the newest sample stands in it, and the one that was returned.
  std::size_t slots() const { return memory_.line.length(); }
  std::size_t newest_slot() const { return memory_.line.slot(0); }
  std::size_t oldest_slot() const { return memory_.line.slot(delay_); }

 private:
  template <std::size_t kTaps>
  std::int32_t noise_of_pair(bool adapt, std::uint32_t number);
  std::int16_t removed(const BankLevel& level, std::int32_t detail) const;
  void adapt_threshold(std::size_t level, std::uint32_t magnitude, bool adapt);
  void choose_threshold();

  DenoiseParameters parameters_;
  BankMemory memory_;
  OutlierGate gate_;
  std::uint32_t delay_ = 0;
  std::uint32_t late_age_ = 0;      // of the newest sample in level 1's late window
  std::uint32_t samples_ = 0;       // modulo 2^32
  int shift_ = 0;                   // noise_shift()
  std::int32_t rounding_half_ = 0;  // of a shift by that
  NoiseGain gain_;
  bool choice_due_ = false;  // some histogram is full
};

template <>
std::int32_t FilterBank::step<kAnyTaps>(std::int32_t sample, bool adapt);

}  // namespace fog
