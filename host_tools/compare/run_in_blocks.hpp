#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "recording/segments.hpp"
#include "series/block_series.hpp"

namespace fogcomp::compare {

/// What fit, add and compare keep of a recording: its blocks of 1 s, where its segments lie, and
/// how quiet its rows could be. A two-hundredth of a 200 Hz recording's memory, so that many runs
/// can be held at once.
struct RunInBlocks {
  std::string file;  ///< `a.csv + b.csv` where it was joined from several (joined_runs.hpp)
  std::vector<std::string> files;          ///< these; one else
  std::vector<std::uint64_t> rows_hashes;  ///< of each (recording/data_hash.hpp)
  std::size_t refused_rows = 0;            ///< left out because the board would refuse them
  series::BlockSeries blocks;
  std::vector<recording::Segment> segments;  ///< of the recording, in order of time, all of it
  double average_s = 0;                      ///< wanted length of a row
  std::optional<double> noise_floor_dph;     ///< of such a row, from the recording alone
  std::vector<std::string> notes;            ///< what such rows cannot show, a line each
};

/// `average_s` in seconds, > 0: the length of the rows that a model will be judged in. Throws
/// InputError for a rate that does not move (recording/rate_resolution.hpp).
RunInBlocks run_in_blocks(const recording::Recording& recording, double average_s);

}  // namespace fogcomp::compare
