#pragma once

#include <cstdint>

namespace fog {

/// Finds a gyro that has stopped measuring. The noise of a working gyro exceeds one LSB; a dead
/// converter repeats one value or toggles between two neighbours.
class StuckMonitor {
 public:
  /// `stuck_samples` consecutive counts within one LSB are a stuck gyro; 0: never.
  explicit StuckMonitor(std::uint32_t stuck_samples) : stuck_samples_(stuck_samples) {}

  /// Whether the gyro is stuck, `counts` being the newest value.
  bool judge(std::int32_t counts);

 private:
  std::uint32_t stuck_samples_;
  std::uint32_t run_ = 0;   // consecutive counts within [min_, min_ + 1]
  std::uint32_t min_ = 0;   // unsigned, so that differences wrap
  std::uint32_t both_ = 0;  // 1: min_ + 1 has come, too
};

}  // namespace fog
