#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "runs/run.hpp"

namespace fogcomp::runs {

/// The runs of one gyro: those to which a model is fitted, and those that judge it. In no row
/// length: `fit`, `compare` and a diagnosis may look at the same runs in other rows.
struct Runs {
  std::vector<Run> training;
  std::vector<Run> holdouts;
  std::uint32_t data_hash = 0;  ///< CRC-32 of the training data, in this order
  double noise_dph_rthz = 0;    ///< white noise density, rms over the training runs
  std::string read_with{};      ///< masks and cuts, as a model's history has them: " --cut 3600"
  /// One line per excluded or joined file, faults of its rows, and values that no gyro has
  /// (recording/reading.hpp).
  std::vector<std::string> notes;

  /// Of a row of the training runs, rms over them weighted by length; nothing if no run shows one.
  std::optional<double> noise_floor_dph(double row_s) const;
  /// Whether the gyro was switched on more than once.
  bool have_several_power_ons() const;
  /// Training runs, then holdouts.
  std::vector<Run> all() const;
  /// With further cuts. Throws InputError for one that lies in no run.
  Runs with(const std::vector<recording::Cut>& cuts) const;
  /// With one of the training runs as the only holdout.
  Runs without(std::size_t run) const;
};

/// Reads files one after another; only the blocks stay in memory. A file with the rows of an
/// earlier one is left out; one that continues another is joined to its run (join_continued()).
/// `row_lengths_s`: as run_of() takes them; notes are about the first. Throws InputError like
/// read_recording() and run_of(), for a mask or cut that lies in no run, and for a holdout with
/// rows of a training run, which cannot judge.
Runs read_runs(const std::vector<std::string>& training, const std::vector<std::string>& holdouts,
               const recording::ReadOptions& options, const std::vector<double>& row_lengths_s);

/// The same for runs that only judge, a model fitted to `training` if that is known.
Runs read_holdouts(const std::vector<std::string>& files, const recording::ReadOptions& options,
                   const std::vector<double>& row_lengths_s, const std::vector<Run>& training = {});

struct NotedRuns {
  std::vector<Run> runs;
  std::vector<std::string> notes;  ///< a line each
};

/// Joins files of one run, in any order: a file that continues another on the same clock without a
/// gap. A logger that starts a file every hour restarts neither the gyro nor its temperatures. A
/// note for each joined file.
NotedRuns join_continued(std::vector<Run> runs);

}  // namespace fogcomp::runs
