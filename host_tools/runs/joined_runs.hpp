#pragma once

#include <string>
#include <vector>

#include "runs/run.hpp"

namespace fogcomp::runs {

struct NotedRuns {
  std::vector<Run> runs;
  std::vector<std::string> notes;  ///< a line each
};

/// Joins files of one run, in any order: a file that continues another on the same clock without a
/// gap. A logger that starts a file every hour restarts neither the gyro nor its temperatures. A
/// note for each joined file.
NotedRuns join_continued(std::vector<Run> runs);

}  // namespace fogcomp::runs
