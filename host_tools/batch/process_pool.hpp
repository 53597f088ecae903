#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace fogcomp::batch {

/// How jobs are run.
struct PoolSettings {
  std::size_t processes = 1;  ///< at a time
  double time_limit_s = 0;    ///< per job, then it is killed; 0: none
};

/// Callbacks in the owner's process.
struct PoolEvents {
  /// Job `job` has ended. `death`: how its process was killed; "" if it ended by itself.
  std::function<void(std::size_t job, const std::string& death)> ended;
  /// About five times a second.
  std::function<void()> tick;
};

/// Runs `work(job)` for every job from 0 to `jobs` - 1, each in a child process (a copy of this
/// one), so that a failure of one, even out of memory, does not affect the others. `work` returns
/// results in files; an exception ends its process with code 1.
///
/// SIGINT, SIGTERM or SIGHUP ends the children and the call, which returns the signal; else 0. Only
/// for single-threaded programs.
int run_in_processes(std::size_t jobs, const PoolSettings& settings,
                     const std::function<void(std::size_t)>& work, const PoolEvents& events);

}  // namespace fogcomp::batch
