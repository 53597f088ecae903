#include "core/denoise/filter_bank.hpp"

#include "core/denoise/filter_kernels.hpp"
#include "core/fixed_point/saturating_difference.hpp"
#include "core/fixed_point/shift.hpp"
#include "core/fixed_point/words.hpp"
#include "core/signal/quantities.hpp"

namespace fog {
namespace {

// Limit of the outlier gate in LSB of Rate: twice the universal threshold of the finest level,
// about five standard deviations of the samples.
constexpr std::uint32_t outlier_limit(std::uint32_t finest_threshold) {
  return floor_shift(finest_threshold, kDetailFraction - Rate::fractional_bits - 1);
}
static_assert(outlier_limit(kMaxRemoved) <= OutlierGate::kMaxLimit);

// adapt_threshold(): the scale that noise_shift() allows for; a threshold in the unit of the noise.
static_assert(NoiseScale::kMax ==
              kMaxThresholdScale * power_of_two<std::uint32_t>(NoiseScale::kFraction));
static_assert(kMaxNoise <= RiskHistogram::kMaxUniversal);

// step(): noise in LSB of a detail, and half an LSB of Rate.
constexpr int kNoiseBelowRate = kDetailFraction - Rate::fractional_bits;
static_assert((kMaxNoise + 1) * power_of_two<std::uint32_t>(kMaxNoiseShift) +
                  rounding_half<std::uint32_t>(kNoiseBelowRate) <=
              INT32_MAX);

}  // namespace

template <std::size_t kTaps>
FilterBank<kTaps>::FilterBank(const DenoiseParameters& parameters, std::int32_t* line,
                              CoarserLevel<kTaps>* coarser)
    : line_(line, denoise_delay(kTaps, parameters.levels()) + 1, kTaps),
      filters_(parameters.filters.data),
      rule_(parameters.rule),
      clipped_(parameters.mode == ThresholdMode::hard ? 0 : UINT32_MAX),
      shift_(noise_shift(parameters)),
      rounding_half_(static_cast<std::int32_t>(power_of_two<std::uint32_t>(shift_) / 2)),
      coarser_(coarser),
      coarser_end_(coarser) {}

// The state that step() would reach: sample 0 completes a pair on every level; its details are 0.
template <std::size_t kTaps>
void FilterBank<kTaps>::start(const DenoiseParameters& parameters, std::int16_t* slots) {
  if (parameters.levels() == 0) return;
  const std::int32_t* expected = parameters.thresholds.begin();
  finest_.threshold.expected = static_cast<std::uint32_t>(*expected);
  adapt_finest(0);
  std::size_t pairs =
      (line_.length() - kTaps) / 2;  // pairs that a level waits: delay of the levels below it
  CoarserLevel<kTaps>* level = coarser_;
  for (; ++expected != parameters.thresholds.end(); ++level) {
    level->threshold.expected = static_cast<std::uint32_t>(*expected);
    adapt_threshold(level->threshold, 0);
    pairs = (pairs - (kTaps - 1)) / 2;
    level->removed_first = slots;
    level->removed_next = slots;
    slots += pairs + 1;
    level->removed_end = slots;
  }
  coarser_end_ = level;
}

template <std::size_t kTaps>
void FilterBank<kTaps>::prime(std::int32_t sample) {
  line_.fill(sample, kTaps);
  for (auto* level = coarser_; level != coarser_end_; ++level) {
    for (std::int32_t& input : level->inputs) input = sample;
  }
  samples_ = 1;  // sample 0 has been taken
}

// Removed part of a detail: the detail clipped to +-threshold; nothing of one that a hard threshold
// keeps. One comparison tests both ends, because thresholds are below 2^30 (noise_shift).
template <std::size_t kTaps>
[[gnu::always_inline]] inline std::int32_t FilterBank<kTaps>::removed(
    std::int32_t detail, std::uint32_t threshold) const {
  if (static_cast<std::uint32_t>(detail) + threshold > 2 * threshold) {
    const std::int32_t negative = floor_shift(detail, 31);
    detail = (static_cast<std::int32_t>(threshold & clipped_) ^ negative) - negative;
  }
  const std::int32_t half = rounding_half_;
  const int shift = shift_;
  return floor_shift(detail + half, shift);
}

// Scales the universal threshold with the noise and multiplies it by the share that the level's own
// details select. Returns the universal threshold.
template <std::size_t kTaps>
std::uint32_t FilterBank<kTaps>::adapt_threshold(LevelThreshold& threshold,
                                                 std::uint32_t magnitude) {
  const std::uint32_t universal = threshold_scale_.of(threshold.expected);
  threshold.now = universal;
  if (rule_ == ThresholdRule::heursure) {
    threshold.now = universal / RiskHistogram::kWhole * threshold.risk.sixteenths();
    threshold.risk.add(floor_shift(magnitude, shift_), floor_shift(universal, shift_));
    if (threshold.risk.full()) choice_due_ = true;
  }
  return universal;
}

template <std::size_t kTaps>
void FilterBank<kTaps>::adapt_finest(std::uint32_t magnitude) {
  if (follow_noise_) threshold_scale_.follow(magnitude, finest_.threshold.expected);
  gate_.set_limit(outlier_limit(adapt_threshold(finest_.threshold, magnitude)));
}

// Once per sample, in one with little other work. The finest level is adapted first, because its
// next detail comes first.
template <std::size_t kTaps>
void FilterBank<kTaps>::choose_threshold() {
  bool chosen = finest_.threshold.risk.choose();
  for (auto* level = coarser_; !chosen && level != coarser_end_; ++level) {
    chosen = level->threshold.risk.choose();
  }
  choice_due_ = chosen;
}

template <std::size_t kTaps>
std::int32_t FilterBank<kTaps>::step(std::int32_t sample) {
  gate_.push(line_, sample);
  const std::uint32_t number = samples_++;
  std::int32_t noise = 0;
  if ((number & 1U) == 0U) {
    noise = noise_of_pair(number);
  } else {
    if (choice_due_) choose_threshold();
    noise = finest_.waiting_noise;
  }
  const std::int32_t fine =
      shift_left(noise, shift_) + rounding_half<std::int32_t>(kNoiseBelowRate);
  return saturating_difference(line_.oldest(), floor_shift(fine, kNoiseBelowRate));
}

// Level l (from 0) has an input at every 2^l-th sample; every second input, from the first on,
// completes a pair. So the number of levels to run equals the trailing zero bits of the sample
// number.
template <std::size_t kTaps>
[[gnu::always_inline]] inline std::int32_t FilterBank<kTaps>::noise_of_pair(std::uint32_t number) {
  const std::int32_t* const filters = filters_;
  RegisterPair found(split<kTaps>(filters, line_.newest(), line_.oldest(kTaps)));
  if (rule_ != ThresholdRule::fixed) adapt_finest(magnitude_of(found.second()));
  const std::int32_t finest_removed = removed(found.second(), finest_.threshold.now);

  CoarserLevel<kTaps>* level = coarser_;
  std::uint32_t noise = 0;
  for (; level != coarser_end_; ++level) {
    number /= 2U;
    std::int32_t* const inputs = level->inputs.data();
    if ((number & 1U) != 0U) {
      // Here, and not with the pair, because the sample that completes the pairs of all levels has
      // the most to do.
      make_room<kTaps>(inputs);
      inputs[1] = found.first();
      noise = lower_half(level->waiting_noise);
      break;
    }
    inputs[0] = found.first();
    found = RegisterPair(split<kTaps>(filters, inputs, inputs));
    if (rule_ != ThresholdRule::fixed) {
      adapt_threshold(level->threshold, magnitude_of(found.second()));
    }
    level->hold(removed(found.second(), level->threshold.now));
  }

  const std::int32_t* const synthesis = filters + kTaps;
  while (level != coarser_) {
    --level;
    const RegisterPair pair(
        merge<kTaps>(synthesis, level->noise.data(), pack_halves(noise, level->removed())));
    noise = lower_half(pair.first());
    level->waiting_noise = static_cast<std::int16_t>(pair.second());
  }
  const RegisterPair pair(
      merge<kTaps>(synthesis, finest_.noise.data(), pack_halves(noise, finest_removed)));
  finest_.waiting_noise = static_cast<std::int16_t>(pair.second());
  return pair.first();
}

template class FilterBank<2>;
template class FilterBank<4>;
template class FilterBank<6>;
template class FilterBank<8>;
template class FilterBank<10>;
template class FilterBank<12>;
template class FilterBank<14>;
template class FilterBank<16>;
template class FilterBank<18>;
template class FilterBank<20>;
template class FilterBank<22>;
template class FilterBank<24>;
template class FilterBank<26>;
template class FilterBank<28>;
template class FilterBank<30>;

}  // namespace fog
