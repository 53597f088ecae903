#pragma once

#include <cstdint>

#include "core/signal/quantities.hpp"
#include "core/signal/status.hpp"

namespace fog {

/// Finds rates that the gyro cannot have measured: too near the end of its range, or reached faster
/// than anything turns.
class RateMonitor {
 public:
  /// `range` > 0: full scale; `sample_period_us` >= 1.
  RateMonitor(Rate range, std::uint32_t sample_period_us);

  /// `measured` is the calibrated rate `elapsed` samples after the last one judged;
  /// `gyro_valid` is what the demodulator says of it.
  Status judge(Rate measured, bool gyro_valid, std::uint32_t elapsed);

 private:
  bool judge_range(Rate measured, std::uint32_t elapsed);
  bool jumped(Rate measured, std::uint32_t elapsed) const;

  Rate set_at_;    // |rate| at or beyond it: out of range
  Rate clear_at_;  // ... until it has stayed below this for clear_samples_
  std::uint32_t clear_samples_;
  std::uint32_t inside_samples_;  // in a row below clear_at_, up to clear_samples_
  bool out_of_range_ = false;
  std::int64_t most_step_;  // LSB of Rate a sample
  Rate last_{};             // the last one judged
  bool has_accepted_ = false;
  Rate accepted_{};
  std::uint32_t since_accepted_ = 0;  // samples, up to kSamplesForAnything
};

}  // namespace fog
