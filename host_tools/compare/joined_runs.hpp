#pragma once

#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"

namespace fogcomp::compare {

/// Files of one run, in whatever order: a run that goes on where another ends, on the same clock
/// and without a gap, becomes part of it. A logger that begins a file every hour restarts neither
/// the gyro nor its temperatures. Adds a line to `notes` for each that was joined.
std::vector<RunInBlocks> join_continued(std::vector<RunInBlocks> runs,
                                        std::vector<std::string>& notes);

}  // namespace fogcomp::compare
