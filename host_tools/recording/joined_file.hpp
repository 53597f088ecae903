#pragma once

#include "recording/line_numbers.hpp"
#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Gives a recording the columns that it lacks and options.join has: each reading counts from the
/// first row at its time or after it, as on a board, and the rows between are completed like those
/// of a sparse column (sparse_columns.hpp). Throws InputError if the files have no time in common,
/// if one counts from power-on and the other has dates, and if nothing is joined.
void join_file(Recording& recording, LineNumbers& lines, const ReadOptions& options);

}  // namespace fogcomp::recording
