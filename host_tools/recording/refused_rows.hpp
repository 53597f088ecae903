#pragma once

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Takes the rows that the board of a gyro with these limits would refuse (judge_rows) out of
/// `recording`, counts them in its refused_rows, and names them to `watch` with their lines (with
/// their times where `lines` is empty), one message per reason. A temperature that stands still as
/// the board would not believe it is named and kept. Stretches are left as they were. Throws
/// InputError where no row would be left.
void leave_out_refused_rows(Recording& recording, const LineNumbers& lines,
                            const GyroLimits& limits, const ReadWatch& watch);

}  // namespace fogcomp::recording
