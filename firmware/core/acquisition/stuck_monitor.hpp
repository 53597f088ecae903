#pragma once

#include <cstdint>
#include <limits>

namespace fog {

/// Counts of a gyro that has stopped measuring: a dead converter repeats one value or toggles
/// between two neighbours, one behind a loop that stands whispers. A working gyro has its own noise
/// even at rest.
struct StuckLimits {
  std::uint32_t samples = 0;  ///< consecutive counts of a stuck gyro; 0: never
  std::uint32_t band = 1;     ///< largest difference of two of them, counts
};

/// Finds such a gyro.
class StuckMonitor {
 public:
  explicit StuckMonitor(const StuckLimits& limits) : limits_(limits) {}

  /// Whether the gyro is stuck, `counts` being the newest value.
  bool judge(std::int32_t counts);

 private:
  StuckLimits limits_;
  std::uint32_t run_ = 0;  // consecutive counts from lowest_ to highest_, at most limits_.samples
  std::int32_t lowest_ = std::numeric_limits<std::int32_t>::min();
  std::int32_t highest_ = std::numeric_limits<std::int32_t>::max();
};

}  // namespace fog
