#pragma once

#include <string>
#include <vector>

#include "runs/run.hpp"

namespace fogcomp::runs {

/// Joins files of one run, in any order: a file that continues another on the same clock without a
/// gap. A logger that starts a file every hour restarts neither the gyro nor its temperatures. Adds
/// a line to `notes` for each joined file.
std::vector<Run> join_continued(std::vector<Run> runs, std::vector<std::string>& notes);

}  // namespace fogcomp::runs
