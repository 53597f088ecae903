#pragma once

#include <cstddef>
#include <vector>

#include "recording/segments.hpp"

namespace fogcomp::recording {

/// One soak or ramp of a chamber programme.
struct ProgrammePart {
  SegmentKind kind = SegmentKind::soak;
  RowRange rows;
};

/// Splits the rows into soaks and ramps by their temperature. A ramp moves by at least 2 degC at
/// 0.05 degC/min or more; a soak lasts at least 2 min unless it is all there is. A ramp ends when
/// the temperature has settled to within about 0.5 degC, so the tail of a chamber with a time
/// constant belongs to it. Noise and steps of the sensor raise these limits as far as they must.
std::vector<ProgrammePart> find_programme_parts(const Recording& recording, RowRange rows);

}  // namespace fogcomp::recording
