#include "core/denoise/filter_bank.hpp"

#include <array>

#include "core/denoise/filter_kernels.hpp"
#include "core/fixed_point/shift.hpp"
#include "core/signal/quantities.hpp"

namespace fog {
namespace {

// Input and approximation have the format of Rate; a detail is held finer.
constexpr int kDetailShift = kTapFraction + Rate::fractional_bits - kDetailFraction;

std::uint32_t magnitude_of(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? 0U - bits : bits;
}

std::uint32_t pack(std::int32_t coarser_noise, std::int32_t removed) {
  return (static_cast<std::uint32_t>(removed) << 16U) |
         (static_cast<std::uint32_t>(coarser_noise) & 0xFFFFU);
}

// Gives back what was put in delay_length pairs ago.
std::int32_t exchange(BankLevel& level, std::int16_t removed) {
  const std::uint32_t next = level.delay_next;
  const std::uint32_t length = level.delay_length;
  if (length == 0) return removed;
  const std::int32_t oldest = level.removed_delay[next];
  level.removed_delay[next] = removed;
  level.delay_next = static_cast<std::uint16_t>(next + 1 == length ? 0 : next + 1);
  return oldest;
}

// The outlier gate's limit in LSB of Rate: twice the universal threshold of the finest level, which
// is some five times the standard deviation of the samples.
std::uint32_t outlier_limit(std::uint32_t finest_threshold) {
  return finest_threshold >> (kDetailFraction - Rate::fractional_bits - 1);
}

}  // namespace

FilterBank::FilterBank(const DenoiseParameters& parameters, const BankMemory& memory)
    : parameters_(parameters),
      memory_(memory),
      delay_(static_cast<std::uint32_t>(denoise_delay(parameters.taps(), parameters.levels()))),
      late_age_(static_cast<std::uint32_t>(
          2 * denoise_delay(parameters.taps(), parameters.levels() - 1))),
      shift_(noise_shift(parameters)),
      rounding_half_(shift_ > 0 ? rounding_half<std::int32_t>(shift_) : 0) {
  for (std::size_t i = 0; i < parameters.levels(); ++i) {
    memory_.levels[i].threshold = static_cast<std::uint32_t>(parameters.thresholds[i]);
  }
  gate_.set_limit(outlier_limit(memory_.levels[0].threshold));
}

void FilterBank::prime(std::int32_t value) {
  memory_.line.fill(value);
  for (BankLevel& level : memory_.levels) level.waiting_input = value;
  const std::size_t inputs = (parameters_.levels() - 1) * parameters_.taps();
  for (std::size_t i = 0; i < inputs; ++i) memory_.inputs[i] = value;
}

// What thresholding takes away from a detail.
inline std::int16_t FilterBank::removed(const BankLevel& level, std::int32_t detail) const {
  const auto threshold = static_cast<std::int32_t>(level.threshold);
  if (detail > threshold || detail < -threshold) {
    if (parameters_.mode == ThresholdMode::hard) return 0;
    detail = detail < 0 ? -threshold : threshold;
  }
  return static_cast<std::int16_t>(floor_shift(detail + rounding_half_, shift_));
}

// The universal threshold follows the noise; how much of it counts, the level's own details.
void FilterBank::adapt_threshold(std::size_t level, std::uint32_t magnitude, bool adapt) {
  BankLevel& here = memory_.levels[level];
  const auto expected = static_cast<std::uint32_t>(parameters_.thresholds[level]);
  if (level == 0 && adapt) gain_.follow(magnitude, expected);
  const auto universal =
      static_cast<std::uint32_t>(std::uint64_t{expected} * gain_.raw() >> NoiseGain::kFraction);
  if (level == 0) gate_.set_limit(outlier_limit(universal));
  here.threshold = universal;
  if (parameters_.rule == ThresholdRule::sqtwolog) return;
  here.threshold = universal / RiskHistogram::kWhole * here.risk.sixteenths();
  here.risk.add(magnitude >> shift_, universal >> shift_);
  choice_due_ = choice_due_ || here.risk.full();
}

// Once a sample, where the bank itself has little to do, and the finest level first: its next
// detail is the first to come.
void FilterBank::choose_threshold() {
  for (BankLevel& level : memory_.levels) {
    if (level.risk.full()) return level.risk.choose();
  }
  choice_due_ = false;
}

template <std::size_t kTaps>
std::int32_t FilterBank::step(std::int32_t sample, bool adapt) {
  gate_.push(memory_.line, sample);
  const std::uint32_t number = samples_++;
  std::int32_t noise = memory_.levels[0].waiting_noise;
  if ((number & 1U) == 0U) {
    noise = noise_of_pair<kTaps>(adapt, number);
  } else if (choice_due_) {
    choose_threshold();
  }
  const std::int32_t removed_rate =
      round_shift(shift_left(noise, shift_), kDetailFraction - Rate::fractional_bits);
  return saturate<std::int32_t>(std::int64_t{memory_.line.from(delay_)[0]} - removed_rate);
}

// Level l (from 0) gets an input at every 2^l-th sample, and every second of these, beginning with
// the first, completes a pair: as many levels as the sample number has zeros at its end.
template <std::size_t kTaps>
std::int32_t FilterBank::noise_of_pair(bool adapt, std::uint32_t number) {
  constexpr auto kInputHalf = rounding_half<std::int64_t>(kTapFraction);
  constexpr auto kDetailHalf = rounding_half<std::int64_t>(kDetailShift);
  std::array<std::int32_t, kMostLevels> removed_now;
  const std::int32_t* const low = parameters_.low.data;
  const std::int32_t* const high = parameters_.high.data;
  const std::int32_t* const synthesis = parameters_.synthesis.data;
  BankLevel* const levels = memory_.levels.data;
  const std::size_t level_count = memory_.levels.size;
  const bool adaptive = parameters_.rule != ThresholdRule::fixed;
  FilterSums sums{dot<kTaps>(low, memory_.line.from(0), kInputHalf),
                  dot<kTaps>(high, memory_.line.from(late_age_), kDetailHalf)};
  std::int32_t* inputs = memory_.inputs;
  std::size_t level = 0;
  for (;;) {
    const auto detail = saturate<std::int32_t>(floor_shift(sums.high, kDetailShift));
    if (adaptive) adapt_threshold(level, magnitude_of(detail), adapt);
    removed_now[level] = exchange(levels[level], removed(levels[level], detail));
    if (++level == level_count) break;
    const auto input = saturate<std::int32_t>(floor_shift(sums.low, kTapFraction));
    BankLevel& next = levels[level];
    if (((number >> level) & 1U) != 0U) {
      next.waiting_input = input;
      break;
    }
    sums = push_and_split<kTaps>(low, high, inputs, input, next.waiting_input,
                                 {kInputHalf, kDetailHalf});
    inputs += kTaps;
  }
  std::int32_t noise = level < level_count ? levels[level].waiting_noise : 0;
  std::uint32_t* window = memory_.noise_windows + level * (kTaps / 2);
  do {
    --level;
    window -= kTaps / 2;
    const NoisePair pair = merge<kTaps>(synthesis, window, pack(noise, removed_now[level]));
    levels[level].waiting_noise = static_cast<std::int16_t>(pair.odd);
    noise = pair.even;
  } while (level > 0);
  return noise;
}

template std::int32_t FilterBank::step<2>(std::int32_t, bool);
template std::int32_t FilterBank::step<4>(std::int32_t, bool);
template std::int32_t FilterBank::step<6>(std::int32_t, bool);
template std::int32_t FilterBank::step<8>(std::int32_t, bool);
template std::int32_t FilterBank::step<10>(std::int32_t, bool);
template std::int32_t FilterBank::step<12>(std::int32_t, bool);
template std::int32_t FilterBank::step<14>(std::int32_t, bool);
template std::int32_t FilterBank::step<16>(std::int32_t, bool);
template std::int32_t FilterBank::step<18>(std::int32_t, bool);
template std::int32_t FilterBank::step<20>(std::int32_t, bool);
template std::int32_t FilterBank::step<22>(std::int32_t, bool);
template std::int32_t FilterBank::step<24>(std::int32_t, bool);
template std::int32_t FilterBank::step<26>(std::int32_t, bool);
template std::int32_t FilterBank::step<28>(std::int32_t, bool);
template std::int32_t FilterBank::step<30>(std::int32_t, bool);

template <>
std::int32_t FilterBank::step<kAnyTaps>(std::int32_t sample, bool adapt) {
  using Step = std::int32_t (FilterBank::*)(std::int32_t, bool);
  static constexpr Step kByPairs[] = {
      &FilterBank::step<2>,  &FilterBank::step<4>,  &FilterBank::step<6>,  &FilterBank::step<8>,
      &FilterBank::step<10>, &FilterBank::step<12>, &FilterBank::step<14>, &FilterBank::step<16>,
      &FilterBank::step<18>, &FilterBank::step<20>, &FilterBank::step<22>, &FilterBank::step<24>,
      &FilterBank::step<26>, &FilterBank::step<28>, &FilterBank::step<30>};
  static_assert(sizeof kByPairs / sizeof kByPairs[0] == kMostTaps / 2);
  return (this->*kByPairs[parameters_.taps() / 2 - 1])(sample, adapt);
}

}  // namespace fog
