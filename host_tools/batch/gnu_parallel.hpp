#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fogcomp::batch {

/// How GNU parallel runs commands.
struct ParallelSettings {
  std::size_t jobs = 0;     ///< at a time; 0: one per processor
  double time_limit_s = 0;  ///< per command, then it is killed; 0: none
  std::string folder;       ///< gets commands.txt, a line a command, and jobs.txt, parallel's log
};

/// The command line that runs the commands in settings.folder, as a shell takes it.
std::string parallel_line(const ParallelSettings& settings);

/// Runs every command line, each a process of its own, so that a failure of one, even out of
/// memory, does not affect the others. Returns how each ended, "" for exit codes 0 and 1; nothing
/// if Ctrl-C has ended all. Throws InputError if GNU parallel is missing, or the folder is not
/// writable.
std::optional<std::vector<std::string>> run_parallel(const std::vector<std::string>& commands,
                                                     const ParallelSettings& settings);

}  // namespace fogcomp::batch
