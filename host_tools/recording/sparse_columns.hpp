#pragma once

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Gives every row a value of the columns that have one now and then (NaN elsewhere): between
/// readings of at most a minute, for as long as a board holds a temperature, on a straight line;
/// behind the last one, as long, that one. Rows that then still lack their temperature or input
/// rate are left out, and so is another column that is nowhere near complete. What was done is
/// told to `watch`. Throws InputError where no row has a temperature.
void complete_sparse_columns(Recording& recording, LineNumbers& lines, const ReadWatch& watch);

}  // namespace fogcomp::recording
