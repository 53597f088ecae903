#include "core/acquisition/stuck_monitor.hpp"

namespace fog {

bool StuckMonitor::judge(std::int32_t counts) {
  const std::int64_t least = counts < least_ ? counts : least_;
  const std::int64_t most = counts > most_ ? counts : most_;
  if (run_ == 0 || most - least > 1) {
    run_ = 1;
    least_ = most_ = counts;
  } else {
    // Stops counting where it has seen enough: a gyro that has been stuck for months still is.
    if (run_ < stuck_samples_) ++run_;
    least_ = least;
    most_ = most;
  }
  return stuck_samples_ != 0 && run_ >= stuck_samples_;
}

}  // namespace fog
