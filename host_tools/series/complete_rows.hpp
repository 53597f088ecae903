#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::series {

/// Means of a recording over rows of one length, all of them complete: what is said of a recording
/// by itself needs means that weigh the same. (The rows of a fit, rows.hpp, begin where the board's
/// blocks do and may be incomplete, which their weight says.)
struct CompleteRows {
  /// Itself a recording, whose time is the centre of each row and whose period is a row's length.
  recording::Recording means;
  std::size_t samples_per_row = 1;
  std::vector<std::size_t> first_samples;  ///< of each row, in the recording it was made from
};

/// round(average_s / period), at least 1.
std::size_t samples_per_row(const recording::Recording& recording, double average_s);

/// Means of all columns over samples_per_row() samples; never across a gap. The incomplete row at
/// the end of a stretch is dropped; where no stretch is as long as a row, the longest makes the
/// only one.
CompleteRows complete_rows(const recording::Recording& recording, double average_s);

}  // namespace fogcomp::series
