#pragma once

#include <cstddef>
#include <vector>

#include "recording/mask.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Changes of the input rate from one steady rate to another that the record does not tell as the
/// gyro saw them.
struct UnknownFlanks {
  std::size_t flanks = 0;
  double length_s = 0;
  std::vector<Mask> masks;  ///< in order of time, whole blocks of a second
};

/// How the gyro differs from the record over each flank, as an angle: a record that is late by a
/// constant time differs by that time times the change of the rate, whatever its course. Where the
/// angles scatter about that by more than the gyro's noise, the flanks are those of another
/// movement: a commanded rate without the table's acceleration, readings that are points in time.
/// Then all of them are unknown, each until gyro and record agree again as they do at a steady
/// rate. None if there are fewer than rules::kMinFlanks, or the input rate never stands still.
/// Needs stretches (find_stretches()); times in `recording.masks` do not count.
UnknownFlanks unknown_flanks(const Recording& recording);

}  // namespace fogcomp::recording
