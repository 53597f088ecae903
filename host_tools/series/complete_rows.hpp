#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::series {

/// Means of a recording over complete rows of one length: statements about a recording alone need
/// means of equal weight. (Rows of a fit, rows.hpp, begin with the board's blocks and may be
/// incomplete, which their weight shows.)
struct CompleteRows {
  /// A recording whose times are the centres of the rows and whose period is the row length.
  recording::Recording means;
  std::size_t samples_per_row = 1;
  std::vector<std::size_t> first_samples;  ///< of each row, in the original recording
};

/// round(average_s / period), at least 1.
std::size_t samples_per_row(const recording::Recording& recording, double average_s);

/// Means of all columns over samples_per_row() samples, never across a gap. The incomplete row at
/// the end of a stretch is dropped; if no stretch is as long as a row, the longest stretch is the
/// only row.
CompleteRows complete_rows(const recording::Recording& recording, double average_s);

}  // namespace fogcomp::series
