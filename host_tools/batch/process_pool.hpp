#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace fogcomp::batch {

/// How jobs are run.
struct PoolSettings {
  std::size_t processes = 1;  ///< at a time
  double time_limit_s = 0;    ///< of one job, after which it is ended; 0: none
};

/// What the pool tells its owner, in the owner's process.
struct PoolEvents {
  /// Job `job` is over. `death`: how its process died, in words; "" where it ended by itself.
  std::function<void(std::size_t job, const std::string& death)> ended;
  /// About five times a second.
  std::function<void()> tick;
};

/// Runs `work(job)` for every job from 0 to `jobs` - 1, each in a child process of this one, which
/// is a copy of it: whatever happens to one, out of memory included, the others do not notice. What
/// `work` has to say it writes to files; what it throws ends its process with code 1.
///
/// SIGINT, SIGTERM or SIGHUP ends the children and the call, which then returns the signal; else 0.
/// To be called from a program with a single thread.
int run_in_processes(std::size_t jobs, const PoolSettings& settings,
                     const std::function<void(std::size_t)>& work, const PoolEvents& events);

}  // namespace fogcomp::batch
