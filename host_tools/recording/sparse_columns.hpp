#pragma once

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Completes columns with values in some rows only (NaN elsewhere). Between readings at most a
/// minute apart, the time for which a board holds a temperature, it interpolates linearly, the
/// input rate as complete_input_rate() does, with masks where it is unknown; after the last reading
/// it repeats that for as long. Then removes rows without temperature or input
/// rate, and other columns that are far from complete. Reports to `watch`. Throws InputError if no
/// row has a temperature.
void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch);

}  // namespace fogcomp::recording
