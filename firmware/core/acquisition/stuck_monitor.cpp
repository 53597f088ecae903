#include "core/acquisition/stuck_monitor.hpp"

namespace fog {

bool StuckMonitor::judge(std::int32_t counts) {
  const std::uint32_t above = static_cast<std::uint32_t>(counts) - min_;
  // One below is possible, too, if all have been equal.
  const std::uint32_t above_lowest = above + 1 - both_;
  if (run_ == 0 || above_lowest > 2 - both_) {
    run_ = 1;
    both_ = 0;
    min_ += above;
  } else {
    // Saturates: a gyro stuck for months must not wrap the count.
    if (run_ < stuck_samples_) ++run_;
    if (above != 0) both_ = 1;
    if (above > 1) --min_;
  }
  return stuck_samples_ != 0 && run_ >= stuck_samples_;
}

}  // namespace fog
