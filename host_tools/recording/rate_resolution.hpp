#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// How finely a recording's rate is written, and whether it moves at all.
struct RateResolution {
  double step_dph = 0;   ///< smallest step from one row to the next that is not 0; 0: none
  double range_dph = 0;  ///< max - min
  double size_dph = 0;   ///< largest magnitude

  /// Whether there is more than the rounding of numbers as large as the rate, or 1 deg/h. A gyro's
  /// rate always does: its noise is 10^9 times that.
  bool moves() const;
  /// Standard deviation of a row's rounding: uniform within a step, or what a sum of products of
  /// such numbers is off by where they have more digits.
  double rounding_dph() const;
};
RateResolution rate_resolution(const Recording& recording);

/// Throws InputError where a recording has two rows or more and its rate does not move: a gyro that
/// is off or not connected, about which no question can be answered.
void require_moving_rate(const Recording& recording);

}  // namespace fogcomp::recording
