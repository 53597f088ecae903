#pragma once

#include <cstddef>
#include <cstdint>

#include "core/denoise/denoise_parameters.hpp"
#include "core/fixed_point/dual_product.hpp"
#include "core/fixed_point/shift.hpp"
#include "core/fixed_point/words.hpp"
#include "core/signal/quantities.hpp"

// Inner loops of the filter bank, unrolled for the number of taps; for filter_bank.cpp only, which
// is compiled with options that suit them (core/CMakeLists.txt) and change no result. -fno-tree-ter
// and -fno-tree-coalesce-vars keep neighbouring reads together, so that they become one instruction
// (LDRD). -fno-if-conversion2 keeps rare cases in branches. Each loop is a function of its own,
// because only then GCC keeps all its sums in registers.
namespace fog {

// Input and approximation have the format of Rate; a detail is held finer.
constexpr int kDetailShift = kTapFraction + Rate::fractional_bits - kDetailFraction;
static_assert(kDetailShift <= kTapFraction);  // split(): kMaxTapSum allows for the larger half

/// One step of a level: approximation of the `newest` inputs and detail of the `oldest` (kTaps
/// each, newest first; the same window on all levels but 1). high[i] = (-1)^i low[taps - 1 - i], so
/// each tap is read once for both. Two neighbours are read at a time, in one instruction. sum |tap|
/// < 2 keeps all sums below 2^63.
template <std::size_t kTaps>
[[gnu::noinline]] std::uint64_t split(const std::int32_t* low, const std::int32_t* newest,
                                      const std::int32_t* oldest) {
  auto low_sum = rounding_half<std::int64_t>(kTapFraction);
  auto even_sum = rounding_half<std::int64_t>(kDetailShift);
  std::int64_t odd_sum = 0;
#pragma GCC unroll 15
  for (std::size_t i = 0; i < kTaps; i += 2) {
    const std::int32_t tap = low[i];
    const std::int32_t next_tap = low[i + 1];
    const std::int32_t newer = newest[i];
    const std::int32_t older = newest[i + 1];
    low_sum += std::int64_t{tap} * newer;
    low_sum += std::int64_t{next_tap} * older;
    const std::int32_t even = oldest[kTaps - 2 - i];
    const std::int32_t odd = oldest[kTaps - 1 - i];
    even_sum += std::int64_t{next_tap} * even;
    odd_sum += std::int64_t{tap} * odd;
  }
  return RegisterPair::of(saturating_shift<kTapFraction>(low_sum),
                          saturating_shift<kDetailShift>(even_sum - odd_sum));
}

/// Moves `window` (kTaps values, newest first) by two, so that its first two are free.
template <std::size_t kTaps>
[[gnu::always_inline]] inline void make_room(std::int32_t* window) {
#pragma GCC unroll 15
  for (std::size_t i = kTaps - 2; i > 0; i -= 2) {
    const std::int32_t newer = window[i - 2];
    const std::int32_t older = window[i - 1];
    window[i] = newer;
    window[i + 1] = older;
  }
}

/// Shifts `newest` (coarser noise in the lower half, removed detail in the upper) into `window`
/// (kTaps / 2 such words, newest first) and returns the two finer values, even and odd. The
/// synthesis filters are the analysis filters reversed, times 2 for the normalisation, so the shift
/// is one less than the fraction of the taps. Word taps - 1 - i holds the halves of word i
/// exchanged, one of them negated, so that each word is read once for both outputs. noise_shift()
/// keeps every sum within 30 bits.
template <std::size_t kTaps>
[[gnu::noinline]] std::uint64_t merge(const std::int32_t* synthesis, std::uint32_t* window,
                                      std::uint32_t newest) {
  constexpr std::size_t kWords = kTaps / 2;
  constexpr int kDropped = kSynthesisTapFraction - 1;
  std::uint32_t words[kWords];
  words[0] = newest;
#pragma GCC unroll 15
  for (std::size_t i = 1; i < kWords; ++i) words[i] = window[i - 1];
#pragma GCC unroll 15
  for (std::size_t i = 0; i < kWords; ++i) window[i] = words[i];
  auto even = rounding_half<std::int32_t>(kDropped);
  std::int32_t odd = even;
#pragma GCC unroll 8
  for (std::size_t i = 0; i < (kWords + 1) / 2; ++i) {
    const auto even_taps = static_cast<std::uint32_t>(synthesis[2 * i]);
    const auto odd_taps = static_cast<std::uint32_t>(synthesis[2 * i + 1]);
    const std::uint32_t mirrored = words[kWords - 1 - i];
    even = add_dual_product(words[i], even_taps, even);
    odd = add_dual_product(words[i], odd_taps, odd);
    if (2 * i + 1 == kWords) break;
    even = add_crossed_product(mirrored, odd_taps, even);
    odd = add_crossed_product(even_taps, mirrored, odd);
  }
  return RegisterPair::of(floor_shift(even, kDropped), floor_shift(odd, kDropped));
}

}  // namespace fog
