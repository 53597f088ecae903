#pragma once

#include <cstdint>

namespace fog {

/// Finds a gyro that has stopped measuring: its noise alone moves a live one by more than an LSB.
/// Counts that toggle between two neighbours are as dead as equal ones, because a converter at rest
/// does that.
class StuckMonitor {
 public:
  /// So many counts in a row within one LSB are a stuck gyro; 0: never.
  explicit StuckMonitor(std::uint32_t stuck_samples) : stuck_samples_(stuck_samples) {}

  /// Whether the gyro is stuck, with these counts the newest.
  bool judge(std::int32_t counts);

 private:
  std::uint32_t stuck_samples_;
  std::uint32_t run_ = 0;  // counts within [min_, min_ + 1] or less, in a row
  std::int64_t min_ = 0;   // wide, so that differences cannot overflow
  std::int64_t max_ = 0;
};

}  // namespace fog
