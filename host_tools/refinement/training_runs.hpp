#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataset/recording.hpp"
#include "evaluation/run_in_blocks.hpp"

namespace fogcomp {

/// Recordings that a model is fitted to or judged by.
struct TrainingRuns {
  std::vector<RunInBlocks> runs;
  std::uint32_t data_hash = 0;  ///< CRC-32 of what a fit sees of them, in this order
  double noise_dph_rthz = 0;    ///< white noise density, rms of the runs'
  /// Of a row, rms of the runs' by their length; nothing where no run shows one.
  std::optional<double> noise_floor_dph;
};

/// Reads `files` one after another; of each only the blocks stay in memory. `average_s`: rows of
/// the fit, seconds. Throws InputError as read_recording() does.
TrainingRuns read_training_runs(const std::vector<std::string>& files, const ReadOptions& options,
                                double average_s);

}  // namespace fogcomp
