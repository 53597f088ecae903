#include "fit/training_runs.hpp"

#include <cmath>
#include <utility>

#include "compare/joined_runs.hpp"
#include "core/bytes/crc.hpp"
#include "noise/white_noise.hpp"
#include "recording/data_hash.hpp"
#include "recording/plausibility.hpp"
#include "support/input_error.hpp"

namespace fogcomp::fit {
namespace {

std::optional<double> common_floor(const std::vector<compare::RunInBlocks>& runs) {
  double square = 0;
  double length_s = 0;
  for (const compare::RunInBlocks& run : runs) {
    if (!run.noise_floor_dph) continue;
    const double run_s = static_cast<double>(run.blocks.blocks.size()) * run.blocks.block_s;
    square += run_s * std::pow(*run.noise_floor_dph, 2);
    length_s += run_s;
  }
  if (length_s == 0) return std::nullopt;
  return std::sqrt(square / length_s);
}

}  // namespace

TrainingRuns read_training_runs(const std::vector<std::string>& files,
                                const recording::ReadOptions& options, double average_s) {
  TrainingRuns training;
  training.data_hash = fog::kCrc32Initial;
  double noise_square = 0;
  recording::KnownRows known;
  for (const std::string& file : files) {
    const recording::Recording recording = recording::read_recording(file, options);
    compare::RunInBlocks run = compare::run_in_blocks(recording, average_s);
    const std::string same = known.file_with(run.blocks.recordings[0]);
    if (!same.empty()) {
      training.notes.push_back(recording::same_rows_words(file, same));
      continue;
    }
    known.add(run.blocks.recordings, run.files);
    training.notes.insert(training.notes.end(), run.notes.begin(), run.notes.end());
    training.data_hash = recording::data_hash(recording, training.data_hash);
    const double noise_dph_rthz = noise::white_noise_dph_rthz(recording);
    const std::vector<std::string> doubts = recording::doubts(recording, noise_dph_rthz);
    training.doubts.insert(training.doubts.end(), doubts.begin(), doubts.end());
    noise_square += std::pow(noise_dph_rthz, 2);
    training.runs.push_back(std::move(run));
  }
  training.noise_dph_rthz = std::sqrt(noise_square / static_cast<double>(training.runs.size()));
  training.runs = compare::join_continued(std::move(training.runs), training.notes);
  training.noise_floor_dph = common_floor(training.runs);
  return training;
}

Holdouts read_holdouts(const std::vector<std::string>& files, const recording::ReadOptions& options,
                       double average_s, const std::vector<compare::RunInBlocks>& training) {
  recording::KnownRows fitted;
  for (const compare::RunInBlocks& run : training) fitted.add(run.blocks.recordings, run.files);
  recording::KnownRows known;
  Holdouts holdouts;
  for (const std::string& file : files) {
    compare::RunInBlocks run =
        compare::run_in_blocks(recording::read_recording(file, options), average_s);
    const std::string same = fitted.file_with(run.blocks.recordings[0]);
    if (!same.empty()) {
      throw InputError(file, "has the same samples as " + same +
                                 ", which is fitted to; a holdout must be another run");
    }
    const std::string twice = known.file_with(run.blocks.recordings[0]);
    if (!twice.empty()) {
      holdouts.notes.push_back(recording::same_rows_words(file, twice));
      continue;
    }
    known.add(run.blocks.recordings, run.files);
    holdouts.notes.insert(holdouts.notes.end(), run.notes.begin(), run.notes.end());
    holdouts.runs.push_back(std::move(run));
  }
  holdouts.runs = compare::join_continued(std::move(holdouts.runs), holdouts.notes);
  return holdouts;
}

}  // namespace fogcomp::fit
