#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// A change of the rate from one sample to the next, deg/h: up to twice what Rate holds.
using RateStep = Fixed<std::int32_t, Rate::fractional_bits - 1>;

/// What a gyro measures and what it is built into can do.
struct RateLimits {
  Rate range = Rate::highest();         ///< full scale, > 0
  RateStep step = RateStep::highest();  ///< the largest angular acceleration, in a sample; > 0
};

/// Finds rates that the gyro cannot have measured: too near the end of its range, folded into it,
/// or reached faster than anything turns.
class RateMonitor {
 public:
  /// `sample_period_us` >= 1.
  RateMonitor(const RateLimits& limits, std::uint32_t sample_period_us);

  /// `measured` is the calibrated rate `elapsed` samples after the last one judged; `trusted`:
  /// nothing else speaks against it.
  Status judge(Rate measured, bool trusted, std::uint32_t elapsed);

 private:
  bool judge_range(Rate measured, std::uint32_t elapsed);
  bool jumped(Rate measured, std::uint32_t elapsed) const;

  Rate range_;
  Rate set_at_;    // |rate| at or beyond it: out of range
  Rate clear_at_;  // ... until it has stayed below this for clear_samples_
  std::uint32_t clear_samples_;
  std::uint32_t inside_samples_;  // in a row below clear_at_, up to clear_samples_
  bool out_of_range_ = false;
  std::int64_t max_step_;  // LSB of Rate a sample; below 2^32
  Rate last_{};            // the last one judged
  bool has_accepted_ = false;
  Rate accepted_{};
  std::uint32_t since_accepted_ = 0;  // samples, up to kSamplesForAnything
  std::uint32_t unseen_samples_ = 0;  // since the last one that was trusted, likewise
  bool turned_unseen_ = false;        // since the last accepted one it may have turned about
};

}  // namespace fog
