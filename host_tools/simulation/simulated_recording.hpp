#pragma once

#include <vector>

#include "recording/recording.hpp"
#include "simulation/simulation.hpp"

namespace fogcomp::simulation {

/// A simulated recording with its true contributions.
struct SimulatedRecording {
  recording::Recording recording;  ///< every column, one stretch
  /// One series per Simulation::effect_names(), deg/h, as long as the recording.
  std::vector<std::vector<double>> effects_dph;
};

/// Runs the simulation to its end. `period_s`: of its rows.
SimulatedRecording record(Simulation& simulation, double period_s);

}  // namespace fogcomp::simulation
