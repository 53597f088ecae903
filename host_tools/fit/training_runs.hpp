#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "recording/recording.hpp"

namespace fogcomp::fit {

/// Recordings that a model is fitted to or judged by.
struct TrainingRuns {
  std::vector<compare::RunInBlocks> runs;
  std::uint32_t data_hash = 0;  ///< CRC-32 of what a fit sees of them, in this order
  double noise_dph_rthz = 0;    ///< white noise density, rms of the runs'
  /// Of a row, rms of the runs' by their length; nothing where no run shows one.
  std::optional<double> noise_floor_dph;
  std::vector<std::string> doubts;  ///< figures that no gyro has (recording/plausibility.hpp)
  std::vector<std::string>
      notes;  ///< a line for each file that is left out, and what its rows lack
};

/// Reads `files` one after another; of each only the blocks stay in memory. A file with the rows of
/// one before it is left out; one that goes on where another ends belongs to its run
/// (compare/joined_runs.hpp). `average_s`: rows of the fit, seconds. Throws InputError as
/// read_recording() does.
TrainingRuns read_training_runs(const std::vector<std::string>& files,
                                const recording::ReadOptions& options, double average_s);

struct Holdouts {
  std::vector<compare::RunInBlocks> runs;
  std::vector<std::string> notes;  ///< as of the training runs
};
/// Reads the runs that judge what was fitted to `training`, in the same way. Throws InputError for
/// one with the rows of a training run: what was fitted to them says nothing of others.
Holdouts read_holdouts(const std::vector<std::string>& files, const recording::ReadOptions& options,
                       double average_s, const std::vector<compare::RunInBlocks>& training);
}  // namespace fogcomp::fit
