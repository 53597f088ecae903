#include "core/acquisition/stuck_monitor.hpp"

namespace fog {

bool StuckMonitor::judge(std::int32_t counts) {
  const std::int64_t min = counts < min_ ? counts : min_;
  const std::int64_t max = counts > max_ ? counts : max_;
  if (run_ == 0 || max - min > 1) {
    run_ = 1;
    min_ = max_ = counts;
  } else {
    // Saturates: a gyro stuck for months must not wrap the count.
    if (run_ < stuck_samples_) ++run_;
    min_ = min;
    max_ = max;
  }
  return stuck_samples_ != 0 && run_ >= stuck_samples_;
}

}  // namespace fog
