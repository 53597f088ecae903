#include "core/denoise/denoise_parameters.hpp"

#include "core/fixed_point/shift.hpp"
#include "core/fixed_point/words.hpp"

namespace fog {
namespace {

// Largest gain of the synthesis filter: the larger sum of magnitudes over its even or odd taps,
// times 2^15 / 2. The same for low-pass and high-pass, because one is the other reversed.
std::uint32_t largest_gain(Span<const std::int32_t> synthesis) {
  std::uint32_t sum = 0;
  std::uint32_t other_sum = 0;
  for (const std::int32_t word : synthesis) {  // even and odd taps alternate
    const std::uint32_t next = other_sum + magnitude_of(static_cast<std::int16_t>(word));
    other_sum = sum;
    sum = next;
  }
  return sum > other_sum ? sum : other_sum;
}

constexpr std::uint32_t kMaxGain = UINT16_MAX;
constexpr std::uint32_t kMaxThreshold = power_of_two<std::uint32_t>(30) - 1;

// noise_fits(): a threshold that adapts, and gain * (noise + removed).
static_assert(kMaxThreshold <= UINT32_MAX / kMaxThresholdScale);
static_assert(2 * kMaxNoise + 1 <= UINT32_MAX / kMaxGain);
// FilterBank::removed(): a threshold that passes, twice in 32 bits without a sign, and once with
// half an LSB of noise in 32 bits with one.
static_assert(kMaxRemoved <= kMaxThreshold);
static_assert(kMaxRemoved + rounding_half<std::uint32_t>(kMaxNoiseShift) <= INT32_MAX);
// merge(): before it is shifted, a noise that passes is below kMaxNoise * 2^14; and half an LSB.
constexpr int kMergeShift = kSynthesisTapFraction - 1;
static_assert((kMaxNoise + 1) * power_of_two<std::uint32_t>(kMergeShift) +
                  rounding_half<std::uint32_t>(kMergeShift) <=
              INT32_MAX);

// From the coarsest level down to the finest: noise <= gain * (coarser noise + threshold). Each
// rounding adds at most half an LSB; one LSB is allowed for. A `gain` below 2^16 keeps everything
// within 32 bits.
bool noise_fits(const DenoiseParameters& parameters, std::uint32_t gain, int shift) {
  std::uint32_t noise = 0;
  for (std::size_t level = parameters.levels(); level-- > 0;) {
    auto threshold = static_cast<std::uint32_t>(parameters.thresholds[level]);
    if (threshold > kMaxThreshold) return false;
    if (parameters.rule != ThresholdRule::fixed) threshold *= kMaxThresholdScale;
    const std::uint32_t removed = floor_shift(threshold, shift) + 1;
    if (removed > kMaxNoise) return false;
    noise = floor_shift(gain * (noise + removed), kSynthesisTapFraction - 1) + 1;
    if (noise > kMaxNoise) return false;
  }
  return true;
}

}  // namespace

int noise_shift(const DenoiseParameters& parameters) {
  const std::uint32_t gain = largest_gain(parameters.synthesis());
  if (gain > kMaxGain) return -1;
  for (int shift = 0; shift <= kMaxNoiseShift; ++shift) {
    if (noise_fits(parameters, gain, shift)) return shift;
  }
  return -1;
}

}  // namespace fog
