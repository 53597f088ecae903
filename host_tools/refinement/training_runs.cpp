#include "refinement/training_runs.hpp"

#include <cmath>

#include "core/protocol/crc.hpp"
#include "evaluation/white_noise.hpp"

namespace fogcomp {
namespace {

// What a fit depends on, as one number for the model's history.
std::uint32_t data_hash(const Recording& recording, std::uint32_t crc) {
  const auto add = [&crc](const std::vector<double>& column) {
    crc = fog::crc32(reinterpret_cast<const std::uint8_t*>(column.data()),
                     column.size() * sizeof(double), crc);
  };
  add(recording.time_s);
  add(recording.temperature_degc);
  add(recording.rate_dph);
  add(recording.input_rate_dph);
  return crc;
}

std::optional<double> common_floor(const std::vector<RunInBlocks>& runs) {
  double square = 0;
  double length_s = 0;
  for (const RunInBlocks& run : runs) {
    if (!run.noise_floor_dph) continue;
    const double run_s = static_cast<double>(run.blocks.blocks.size()) * run.blocks.block_s;
    square += run_s * std::pow(*run.noise_floor_dph, 2);
    length_s += run_s;
  }
  if (length_s == 0) return std::nullopt;
  return std::sqrt(square / length_s);
}

}  // namespace

TrainingRuns read_training_runs(const std::vector<std::string>& files, const ReadOptions& options,
                                double average_s) {
  TrainingRuns training;
  training.data_hash = fog::kCrc32Initial;
  double noise_square = 0;
  for (const std::string& file : files) {
    const Recording recording = read_recording(file, options);
    training.data_hash = data_hash(recording, training.data_hash);
    noise_square += std::pow(white_noise_dph_rthz(recording), 2);
    training.runs.push_back(run_in_blocks(recording, average_s));
  }
  training.noise_dph_rthz = std::sqrt(noise_square / static_cast<double>(files.size()));
  training.noise_floor_dph = common_floor(training.runs);
  return training;
}

}  // namespace fogcomp
