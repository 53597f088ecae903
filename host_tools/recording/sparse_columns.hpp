#pragma once

#include <vector>

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Completes a column with readings in some rows only (NaN elsewhere): by straight lines between
/// readings at most kHoldSeconds apart, or different by at most `step` if that is not 0;
/// behind the last reading it repeats that for as long.
void join_by_lines(const std::vector<double>& time_s, std::vector<double>& column, double step = 0);

/// The same for all columns of a recording, the input rate first by draw_input_rate(), with masks
/// where it is unknown, the uptime over restarts. Then removes rows without temperature or input
/// rate, and other columns that are far from complete. Reports to `watch`. Throws InputError if no
/// row has a temperature.
void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch);

}  // namespace fogcomp::recording
