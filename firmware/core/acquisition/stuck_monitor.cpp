#include "core/acquisition/stuck_monitor.hpp"

namespace fog {

bool StuckMonitor::judge(std::int32_t counts) {
  if (counts < lowest_) lowest_ = counts;
  if (counts > highest_) highest_ = counts;
  const std::uint32_t span =
      static_cast<std::uint32_t>(highest_) - static_cast<std::uint32_t>(lowest_);
  if (span > limits_.band) {  // so it is at the first one
    lowest_ = highest_ = counts;
    run_ = 0;
  }
  // Saturates: a gyro stuck for months must not wrap the count.
  if (run_ < limits_.samples) ++run_;
  return limits_.samples != 0 && run_ == limits_.samples;
}

}  // namespace fog
