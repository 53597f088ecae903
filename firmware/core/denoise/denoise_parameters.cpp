#include "core/denoise/denoise_parameters.hpp"

namespace fog {
namespace {

std::int64_t magnitude_of(std::int32_t value) {
  return value < 0 ? -std::int64_t{value} : std::int64_t{value};
}

// Sum of the magnitudes of every second synthesis tap: at most so much of a level's input (times
// 2^15 / 2) comes out of it. `half` 0: low-pass, 1: high-pass.
std::int64_t largest_gain(Span<const std::int32_t> synthesis, std::uint32_t half) {
  std::int64_t sums[2] = {0, 0};
  for (std::size_t i = 0; i < synthesis.size; ++i) {
    const auto word = static_cast<std::uint32_t>(synthesis[i]);
    sums[i % 2] += magnitude_of(static_cast<std::int16_t>(word >> (16U * half)));
  }
  return sums[0] > sums[1] ? sums[0] : sums[1];
}

}  // namespace

int noise_shift(const DenoiseParameters& parameters) {
  const std::int64_t coarse_gain = largest_gain(parameters.synthesis, 0);
  const std::int64_t detail_gain = largest_gain(parameters.synthesis, 1);
  const std::int64_t most_gain =
      parameters.rule == ThresholdRule::fixed ? 1 : std::int64_t{kMostThresholdGain};
  // From the coarsest level up: noise <= coarse_gain * coarser noise + detail_gain * threshold.
  for (int shift = 0; shift <= kMostNoiseShift; ++shift) {
    std::int64_t bound = 0;
    bool fits = true;
    for (std::size_t level = parameters.levels(); level-- > 0;) {
      // Each rounding adds half an LSB at most; one is allowed for.
      const std::int64_t removed = (parameters.thresholds[level] * most_gain >> shift) + 1;
      bound = ((coarse_gain * bound + detail_gain * removed) >> (kSynthesisTapFraction - 1)) + 1;
      fits = fits && removed <= INT16_MAX && bound <= INT16_MAX;
    }
    if (fits) return shift;
  }
  return -1;
}

}  // namespace fog
