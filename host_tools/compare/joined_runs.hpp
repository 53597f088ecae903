#pragma once

#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"

namespace fogcomp::compare {

/// Joins files of one run, in any order: a file that continues another on the same clock without a
/// gap. A logger that starts a file every hour restarts neither the gyro nor its temperatures. Adds
/// a line to `notes` for each joined file.
std::vector<RunInBlocks> join_continued(std::vector<RunInBlocks> runs,
                                        std::vector<std::string>& notes);

}  // namespace fogcomp::compare
