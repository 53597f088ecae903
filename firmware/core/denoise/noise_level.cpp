#include "core/denoise/noise_level.hpp"

#include "core/fixed_point/shift.hpp"
#include "core/signal/quantities.hpp"

namespace fog {
namespace {

// Input and approximation have the format of Rate; a detail is held finer.
constexpr int kDetailShift = kTapFraction + Rate::fractional_bits - kDetailFraction;

void push_front(std::int32_t* values, std::size_t size, std::int32_t newest) {
  for (std::size_t i = size - 1; i > 0; --i) values[i] = values[i - 1];
  values[0] = newest;
}

}  // namespace

void NoiseLevel::prime(std::int32_t value) {
  for (std::size_t i = 0; i < lowpass_.size; ++i) inputs_[i] = value;
  for (std::size_t i = 0; i < lowpass_.size / 2; ++i) coarser_noise_[i] = detail_noise_[i] = 0;
  detail_delay_.fill(0);
  noise_even_ = 0;
  noise_odd_ = 0;
  even_ = false;
}

void NoiseLevel::push(std::int32_t input) {
  push_front(inputs_, lowpass_.size, input);
  even_ = !even_;
}

std::int32_t NoiseLevel::approximation() const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < lowpass_.size; ++i) sum += std::int64_t{lowpass_[i]} * inputs_[i];
  return saturate<std::int32_t>(round_shift(sum, kTapFraction));
}

// The high-pass filter is the low-pass one backwards with alternating signs.
std::int32_t NoiseLevel::detail() const {
  const std::size_t taps = lowpass_.size;
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < taps; i += 2) {
    sum += std::int64_t{lowpass_[taps - 1 - i]} * inputs_[i];
    sum -= std::int64_t{lowpass_[taps - 2 - i]} * inputs_[i + 1];
  }
  return saturate<std::int32_t>(round_shift(sum, kDetailShift));
}

// Synthesis filters are the analysis filters backwards, times 2 for the normalisation. The pair's
// even output meets their even taps, the odd one their odd taps.
void NoiseLevel::reconstruct(std::int32_t coarser_noise, std::int32_t detail_noise) {
  const std::size_t taps = lowpass_.size;
  push_front(coarser_noise_, taps / 2, coarser_noise);
  push_front(detail_noise_, taps / 2, detail_delay_.exchange(detail_noise));
  std::int64_t even = 0;
  std::int64_t odd = 0;
  for (std::size_t k = 0; k < taps / 2; ++k) {
    const std::int64_t coarse = coarser_noise_[k];
    const std::int64_t fine = detail_noise_[k];
    even += coarse * lowpass_[taps - 1 - 2 * k] - fine * lowpass_[2 * k];
    odd += coarse * lowpass_[taps - 2 - 2 * k] + fine * lowpass_[2 * k + 1];
  }
  noise_even_ = saturate<std::int32_t>(round_shift(even, kTapFraction - 1));
  noise_odd_ = saturate<std::int32_t>(round_shift(odd, kTapFraction - 1));
}

}  // namespace fog
