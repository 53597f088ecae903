#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recording/recording_writer.hpp"
#include "simulation/gyro_description.hpp"
#include "simulation/programme.hpp"
#include "simulation/simulation.hpp"
#include "workflow/observer.hpp"

namespace fogcomp::workflow {

struct SimulateRequest {
  std::string profile = "paper";     ///< ready-made one or file
  std::string preset = "paper";      ///< of the gyro; ready-made one or file; none: an ideal gyro
  std::vector<std::string> without;  ///< effects of the preset to disable
  std::vector<std::string> effects;  ///< `NAME[:k=v,...]`: effects to enable or change
  std::vector<std::string> noise;    ///< `k=v,...` or `none`
  simulation::SimulationOptions options;
  std::string columns;  ///< extra ones, `NAME,...` or `all`
  recording::RecordingFormat format = recording::RecordingFormat::csv;
};

/// A gyro in its chamber, for one run. Must not be moved, because it refers to itself.
class SimulatedChamber {
 public:
  /// Throws InputError for unknown names, values out of range, a column that the format cannot
  /// hold, and an impossible peak.
  explicit SimulatedChamber(const SimulateRequest& request);
  SimulatedChamber(const SimulatedChamber&) = delete;
  SimulatedChamber& operator=(const SimulatedChamber&) = delete;

  const simulation::GyroDescription& gyro() const { return gyro_; }
  const simulation::Simulation& simulation() const { return simulation_; }
  /// Columns of the recording: time, temperature, rate, then the requested ones; the input rate
  /// also if there is one.
  const std::vector<recording::Column>& columns() const { return columns_; }
  double duration_s() const { return programme_.duration_s(); }

  /// Passes the whole run to `sink`, chunk by chunk, and returns its number of rows. Throws
  /// InputError for a programme shorter than a row.
  std::size_t run(const std::function<void(const simulation::RowChunk&)>& sink,
                  const Observer& observer = {});

 private:
  SimulateRequest request_;
  simulation::GyroDescription gyro_;
  simulation::Programme programme_;
  std::vector<recording::Column> columns_;
  simulation::Simulation simulation_;
};

}  // namespace fogcomp::workflow
