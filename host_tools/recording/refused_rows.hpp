#pragma once

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Removes from `recording` the samples that the board of a gyro with these limits would refuse
/// (refused_rows()), counts them in recording.refused_rows, and reports them to `watch` with their
/// lines (without `lines`: with their times), one message per reason. Frozen temperatures, and
/// stretches in which another column has one value that stands for none, are reported and kept.
/// Stretches are unchanged. Throws InputError if no sample would be left.
void leave_out_refused_rows(Recording& recording, const LineNumbers& lines,
                            const GyroLimits& limits, const ReadWatch& watch);

}  // namespace fogcomp::recording
