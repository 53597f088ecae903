#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "recording/recording.hpp"
#include "simulation/gyro_model.hpp"
#include "simulation/noise/noise_source.hpp"
#include "simulation/row_means.hpp"

namespace fogcomp::simulation {

struct SimulationOptions {
  double rate_hz = 0.1;  ///< rows per second; a row is the mean over its period
  std::uint64_t seed = 1;
  EarthRate earth;
  ThermalGrid grid;
};

/// Rows of a run: all columns of a recording (the uptime where the programme switches the power
/// off), and the true values. Times are those of the rows' starts.
struct RowChunk : recording::Recording {
  /// True temperatures, then each effect and noise source by name; all as long as the columns.
  std::vector<double> coil_degc;
  std::vector<double> chamber_degc;
  std::vector<std::vector<double>> effects_dph;
  std::vector<std::vector<double>> noises_dph;
};

/// Runs a gyro through a programme and returns its rows in chunks, in bounded memory.
class Simulation {
 public:
  /// The arguments must outlive the object. Throws InputError for an impossible peak.
  Simulation(const GyroDescription& gyro, const Programme& programme,
             const SimulationOptions& options);

  /// Names of RowChunk::effects_dph and noises_dph.
  const std::vector<std::string>& effect_names() const { return effect_names_; }
  const std::vector<std::string>& noise_names() const { return noise_names_; }
  /// Factor of each effect's natural size, from `peak` or `scale`; 1 without them.
  const std::vector<double>& effect_scales() const { return scales_; }
  /// Rows of the whole programme, including those without power.
  std::size_t total_rows() const { return total_rows_; }
  std::size_t rows_done() const { return row_; }

  /// Fills the next rows; false at the end. Rows in which the power is off, even partly, are left
  /// out, so a chunk may be empty.
  bool next(RowChunk& chunk);

 private:
  std::vector<double> channel_values() const;
  void keep(const std::vector<double>& means, RowChunk& chunk) const;

  std::vector<std::string> effect_names_;
  std::vector<std::string> noise_names_;
  double period_s_;
  std::size_t total_rows_;
  std::vector<double> scales_;
  GyroModel model_;
  std::vector<NamedNoise> noises_;
  AngleQuantizer quantizer_;
  RowMeans means_;
  std::size_t row_ = 0;
  bool switches_power_;
  std::size_t power_on_row_ = 0;  ///< the first with power since it was off
};

/// A simulated recording with its true contributions.
struct SimulatedRecording {
  recording::Recording recording;  ///< every column, one stretch
  /// One series per Simulation::effect_names(), deg/h, as long as the recording.
  std::vector<std::vector<double>> effects_dph;
};

/// Runs the simulation to its end. `period_s`: of its rows.
SimulatedRecording record(Simulation& simulation, double period_s);

}  // namespace fogcomp::simulation
