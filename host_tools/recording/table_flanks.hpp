#pragma once

#include <optional>
#include <vector>

#include "recording/mask.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Changes of the input rate from one steady rate to another that the record does not tell as the
/// gyro saw them.
struct UnknownFlanks {
  std::vector<Mask> masks;        ///< in order of time, whole blocks of a second
  std::optional<double> delay_s;  ///< by which the record is late, negative: early, if that is all
};

/// How the gyro differs from the record over each flank, as an angle: a record that is late by a
/// constant time differs by that time times the change of the rate, whatever its course. Where the
/// angles exceed the gyro's noise, the flanks are unknown, each until gyro and record agree again
/// as they do at a steady rate. Where they scatter about a delay's, too, the flanks are those of
/// another movement: a commanded rate without the table's acceleration, readings that are points in
/// time. The ends of longer movements are left out with them. Flanks of one delay stay if they are
/// most of the recording: late_reference describes them to first order. None if there are fewer
/// than rules::kMinCases, or the input rate never stands still. Needs stretches
/// (find_stretches()); times in `recording.masks` do not count.
UnknownFlanks unknown_flanks(const Recording& recording);

}  // namespace fogcomp::recording
