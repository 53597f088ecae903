#pragma once

#include <cstddef>
#include <cstdint>

#include "core/denoise/denoise_parameters.hpp"
#include "core/fixed_point/dual_product.hpp"
#include "core/fixed_point/shift.hpp"

// The inner loops of the filter bank, unrolled for the number of taps. For filter_bank.cpp only,
// which is compiled with options that suit them (firmware/CMakeLists.txt) and change no result:
// -fno-schedule-insns, because GCC's scheduling before register allocation moves all loads to the
// front, runs out of registers and spills the 64-bit sums; -fno-tree-ter, because it keeps reads of
// neighbours together as they are written here, which become one instruction (LDRD).
namespace fog {

/// start + sum of taps[i] * window[i]; sum |tap| < 2 keeps it below 2^63. Two neighbours are read
/// at a time: the processor does that in one instruction.
template <std::size_t kTaps>
[[gnu::always_inline]] inline std::int64_t dot(const std::int32_t* taps, const std::int32_t* window,
                                               std::int64_t start) {
#pragma GCC unroll 15
  for (std::size_t i = 0; i < kTaps; i += 2) {
    const std::int32_t tap = taps[i];
    const std::int32_t next_tap = taps[i + 1];
    const std::int32_t newer = window[i];
    const std::int32_t older = window[i + 1];
    start += std::int64_t{tap} * newer;
    start += std::int64_t{next_tap} * older;
  }
  return start;
}

/// Sums of the low-pass and of the high-pass filter.
struct FilterSums {
  std::int64_t low;
  std::int64_t high;
};

/// Both sums after taking two samples into `window` (kTaps values, newest first): each value is
/// read once, used twice and written back two places further.
template <std::size_t kTaps>
[[gnu::always_inline]] inline FilterSums push_and_split(const std::int32_t* low,
                                                        const std::int32_t* high,
                                                        std::int32_t* window, std::int32_t newer,
                                                        std::int32_t older, FilterSums sums) {
#pragma GCC unroll 15
  for (std::size_t i = 0; i < kTaps; i += 2) {
    const std::int32_t next_newer = window[i];
    const std::int32_t next_older = window[i + 1];
    window[i] = newer;
    window[i + 1] = older;
    const std::int32_t low_tap = low[i];
    const std::int32_t next_low_tap = low[i + 1];
    sums.low += std::int64_t{low_tap} * newer;
    sums.low += std::int64_t{next_low_tap} * older;
    const std::int32_t high_tap = high[i];
    const std::int32_t next_high_tap = high[i + 1];
    sums.high += std::int64_t{high_tap} * newer;
    sums.high += std::int64_t{next_high_tap} * older;
    newer = next_newer;
    older = next_older;
  }
  return sums;
}

/// The noise of two neighbouring samples.
struct NoisePair {
  std::int32_t even;
  std::int32_t odd;
};

/// Takes `newest` (coarser noise in the lower half, removed detail in the upper) into `window`
/// (kTaps / 2 such words, newest first), whose oldest word leaves; returns the two finer values.
/// The synthesis filters are the analysis filters backwards, times 2 for the normalisation: the
/// shift drops one bit less than the taps have. noise_shift() keeps every sum within 30 bits.
template <std::size_t kTaps>
[[gnu::always_inline]] inline NoisePair merge(const std::int32_t* synthesis, std::uint32_t* window,
                                              std::uint32_t newest) {
  constexpr int kDropped = kSynthesisTapFraction - 1;
  auto even = rounding_half<std::int32_t>(kDropped);
  std::int32_t odd = even;
  const auto add = [&](std::uint32_t word, const std::int32_t* taps) {
    const auto even_taps = static_cast<std::uint32_t>(taps[0]);
    const auto odd_taps = static_cast<std::uint32_t>(taps[1]);
    even = add_dual_product(word, even_taps, even);
    odd = add_dual_product(word, odd_taps, odd);
  };
#pragma GCC unroll 8
  for (std::size_t k = 0; k + 1 < kTaps / 2; k += 2) {
    const std::uint32_t next = window[k];
    const std::uint32_t after_next = window[k + 1];
    window[k] = newest;
    window[k + 1] = next;
    add(newest, synthesis + 2 * k);
    add(next, synthesis + 2 * k + 2);
    newest = after_next;
  }
  if constexpr (kTaps / 2 % 2 == 1) {
    window[kTaps / 2 - 1] = newest;
    add(newest, synthesis + kTaps - 2);
  }
  return {floor_shift(even, kDropped), floor_shift(odd, kDropped)};
}

}  // namespace fog
