#pragma once

#include <cstdint>

#include "core/fixed_point/shift.hpp"
#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Change of the rate from one sample to the next, deg/h: up to twice the range of Rate.
using RateStep = Fixed<std::int32_t, Rate::fractional_bits - 1>;

/// Limits of the gyro and of the vehicle.
struct RateLimits {
  Rate range = Rate::highest();         ///< full scale, > 0
  RateStep step = RateStep::highest();  ///< largest change of the rate per sample; > 0
};

/// Finds rates that the gyro cannot have measured: too near its full scale, folded, of the other
/// sign, or reached faster than the vehicle can turn.
class RateMonitor {
 public:
  /// `sample_period_us` >= 1.
  RateMonitor(const RateLimits& limits, std::uint32_t sample_period_us);

  /// `measured`: calibrated rate, `elapsed` (at most kMaxElapsed) samples after the last one
  /// judged. `trusted`: no other check has failed.
  Status judge(Rate measured, bool trusted, std::uint32_t elapsed);

  static constexpr std::uint32_t kMaxElapsed = 1U << 31U;
  /// Largest step of any table: LSB of Rate per sample.
  static constexpr std::int64_t kMaxStep = shift_left(
      std::int64_t{RateStep::highest().raw()}, Rate::fractional_bits - RateStep::fractional_bits);

 private:
  bool judge_range(Rate measured, std::uint32_t elapsed);
  bool jumped(Rate measured, std::uint32_t elapsed);

  Rate range_;
  Rate set_at_;    // out of range from this |rate| on
  Rate clear_at_;  // ... until |rate| was below this for clear_samples_
  std::uint32_t clear_samples_;
  std::uint32_t inside_samples_;  // consecutive samples below clear_at_, at most clear_samples_
  bool out_of_range_ = false;
  std::int64_t max_step_;  // LSB of Rate per sample; at most kMaxStep
  Rate last_{};            // rate judged last
  bool has_accepted_ = false;
  Rate accepted_{};
  std::uint32_t since_accepted_ = 0;  // samples, at most kMaxElapsedSamples
  std::uint32_t unseen_samples_ = 0;  // samples since the last trusted one, same limit
  bool mirrored_ = false;             // the sign has flipped since the last accepted one
  bool may_have_reversed_ = false;    // the rate may have changed sign since the last accepted one
};

}  // namespace fog
