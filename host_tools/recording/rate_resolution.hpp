#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Resolution of a recording's rate, and whether the rate changes at all.
struct RateResolution {
  double step_dph = 0;   ///< smallest non-zero step between rows; 0: none
  double range_dph = 0;  ///< max - min
  double size_dph = 0;   ///< largest magnitude

  /// Whether the rate changes by more than the rounding of numbers of its size (at least 1 deg/h).
  /// A gyro's rate does: its noise is 10^9 times larger.
  bool varies() const;
  /// Standard deviation of a row's rounding: uniform within a step, or the rounding of a sum of
  /// products if such numbers have more digits.
  double rounding_dph() const;
};
RateResolution rate_resolution(const Recording& recording);

/// Throws InputError if a recording of two or more rows has a constant rate: the gyro is off or not
/// connected.
void require_varying_rate(const Recording& recording);

}  // namespace fogcomp::recording
