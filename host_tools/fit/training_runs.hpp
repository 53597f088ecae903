#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "recording/recording.hpp"

namespace fogcomp::fit {

/// Recordings to which a model is fitted or by which it is judged.
struct TrainingRuns {
  std::vector<compare::RunInBlocks> runs;
  std::uint32_t data_hash = 0;  ///< CRC-32 of the fitted data, in this order
  double noise_dph_rthz = 0;    ///< white noise density, rms over the runs
  /// Of a row, rms over the runs weighted by length; nothing if no run shows one.
  std::optional<double> noise_floor_dph;
  std::vector<std::string> doubts;  ///< values that no gyro has (recording/plausibility.hpp)
  std::vector<std::string> notes;   ///< one line per excluded file, and faults of its rows
};

/// Reads `files` one after another; only the blocks stay in memory. A file with the rows of an
/// earlier one is left out; one that continues another is joined to its run
/// (compare/joined_runs.hpp). `average_s`: row length of the fit, seconds. Throws InputError like
/// read_recording().
TrainingRuns read_training_runs(const std::vector<std::string>& files,
                                const recording::ReadOptions& options, double average_s);

struct Holdouts {
  std::vector<compare::RunInBlocks> runs;
  std::vector<std::string> notes;  ///< as in TrainingRuns
};
/// Reads the runs that judge a model fitted to `training`, in the same way. Throws InputError for
/// one with the rows of a training run, which cannot judge.
Holdouts read_holdouts(const std::vector<std::string>& files, const recording::ReadOptions& options,
                       double average_s, const std::vector<compare::RunInBlocks>& training);
}  // namespace fogcomp::fit
