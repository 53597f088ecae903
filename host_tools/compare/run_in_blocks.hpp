#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "recording/segments.hpp"
#include "series/block_series.hpp"

namespace fogcomp::compare {

/// The part of a recording that fit, add and compare use: its blocks of 1 s, its segments, and its
/// noise floor. A two-hundredth of a 200 Hz recording's memory, so that many runs fit.
struct RunInBlocks {
  std::string file;                ///< `a.csv + b.csv` if joined from several (joined_runs.hpp)
  std::vector<std::string> files;  ///< these; one else
  std::size_t refused_rows = 0;    ///< left out because the board would refuse them
  series::BlockSeries blocks;
  std::vector<recording::Segment> segments;  ///< of the whole recording, in order of time
  double average_s = 0;                      ///< requested row length
  std::optional<double> noise_floor_dph;     ///< of such a row, from the recording alone
  std::vector<std::string> notes;            ///< limitations of such rows, one line each
};

/// `average_s` in seconds, > 0: row length of the comparison. Throws InputError for a constant rate
/// (recording/rate_resolution.hpp).
RunInBlocks run_in_blocks(const recording::Recording& recording, double average_s);

/// Whether there are several runs, or the power was off within one.
bool have_several_power_ons(const std::vector<RunInBlocks>& runs);

}  // namespace fogcomp::compare
