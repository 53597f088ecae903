#include "evaluation/run_in_blocks.hpp"

#include <cmath>

#include "dataset/data_hash.hpp"
#include "dataset/rate_resolution.hpp"
#include "evaluation/noise_floor.hpp"

namespace fogcomp {

RunInBlocks run_in_blocks(const Recording& recording, double average_s) {
  require_moving_rate(recording);
  RunInBlocks run;
  run.file = recording.file;
  run.refused_rows = recording.refused_rows;
  run.rows_hash = rows_hash(recording);
  run.blocks = make_blocks(recording);
  for (const Segment& segment : find_segments(recording)) {
    const bool last = segment.end_row == recording.rows();
    run.segments.push_back(
        {segment.name, segment.kind, last ? HUGE_VAL : recording.time_s[segment.end_row]});
  }
  run.average_s = average_s;
  // Of the rows as they are: a whole number of blocks.
  run.noise_floor_dph = noise_floor_dph(recording, row_length_s(average_s, run.blocks.block_s));
  return run;
}

}  // namespace fogcomp
