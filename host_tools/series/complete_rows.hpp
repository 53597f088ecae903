#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp {

/// Block means of a recording: itself a recording, whose time is the centre of each block and whose
/// period is the block length.
struct Blocks {
  Recording means;
  std::size_t rows_per_block = 1;
  std::vector<std::size_t> first_rows;  ///< of each block, in the recording it was made from
};

/// round(average_s / period), at least 1.
std::size_t rows_per_block(const Recording& recording, double average_s);

/// Means of all columns over rows_per_block() rows; never across a gap. The
/// incomplete block at the end of a stretch is dropped; where no stretch is as long as a block, the
/// longest makes the only one.
Blocks block_means(const Recording& recording, double average_s);

}  // namespace fogcomp
