#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/denoise/adaptive_thresholds.hpp"
#include "core/denoise/denoise_parameters.hpp"
#include "core/signal/output_sample.hpp"
#include "denoise/filters.hpp"
#include "support/removal_bound.hpp"

namespace fog::test {

/// Whether a denoised rate that is called valid stands for the sample of the demodulator that is as
/// many of its samples old as the delay says, lost ones counted: that one came, its undelayed rate
/// was valid, and the denoised one differs from it by no more than a denoiser can remove.
class DenoisedJudge {
 public:
  DenoisedJudge(const DenoiseParameters& parameters, const std::string& wavelet) {
    const auto levels = parameters.levels();
    if (levels == 0) return;
    samples_.resize(denoise_delay(parameters.taps(), levels) + 1);
    const std::vector<double> removals =
        removal_bounds(fogcomp::denoise::lowpass_filter(wavelet), static_cast<int>(levels));
    for (std::size_t i = 0; i < levels; ++i) {
      bound_dph_ +=
          removals[i] * kMaxThresholdScale * std::ldexp(parameters.thresholds[i], -kDetailFraction);
    }
    bound_dph_ *= 1 + kNoiseResolution;
  }

  /// The demodulator has measured once more, whether or not the sample comes.
  void begin_sample() {
    if (samples_.empty()) return;
    newest_ = (newest_ + 1) % samples_.size();
    samples_[newest_] = {};
  }
  /// Returns false for a rate that is called valid and is not that of the delay before. What has
  /// sequence_gap is not judged: the answer to a late sample repeats the denoised rate before.
  bool take(const OutputSample& out) {
    if (samples_.empty()) return true;
    std::optional<Rate>& now = samples_[newest_].rate;
    if (out.compensated_valid() && !now) now = out.compensated;
    if (has_any(out.status, Status::denoiser_filling | Status::sequence_gap)) return true;
    if (!out.denoised_valid()) return true;
    ++valid_;
    const auto& [then, damaged] = samples_[(newest_ + 1) % samples_.size()];
    if (damaged) return true;
    return then && std::abs(dph(out.denoised) - dph(*then)) <= bound_dph_ + dph(Rate::from_raw(1));
  }
  /// The bytes of a sample have made none. Maybe they will, with the next one's.
  void take_damaged() {
    if (!samples_.empty()) samples_[newest_].damaged = true;
  }
  std::uint64_t valid() const { return valid_; }

 private:
  struct Sample {
    std::optional<Rate> rate;  // valid
    bool damaged = false;
  };

  static double dph(Rate rate) { return std::ldexp(rate.raw(), -Rate::fractional_bits); }

  std::vector<Sample> samples_;  // of the delay and the newest
  std::size_t newest_ = 0;
  double bound_dph_ = 0;
  std::uint64_t valid_ = 0;
};

}  // namespace fog::test
