#pragma once

#include <cstddef>
#include <vector>

#include "recording/recording.hpp"
#include "recording/segments.hpp"

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

/// The blocks whose middle row lies in each segment: same names, kinds and order; `first_row` and
/// `end_row` then count blocks and are equal where a segment is too short to have one.
std::vector<Segment> segments_in_blocks(const std::vector<Segment>& segments, const Blocks& blocks);

}  // namespace fogcomp
