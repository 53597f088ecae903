#include "simulation/simulated_recording.hpp"

#include "recording/columns.hpp"

namespace fogcomp::simulation {
namespace {

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

SimulatedRecording record(Simulation& simulation, double period_s) {
  SimulatedRecording result;
  result.effects_dph.resize(simulation.effect_names().size());
  recording::Recording& recording = result.recording;
  recording.period_s = period_s;
  recording.stretch_starts = {0};
  for (RowChunk chunk; simulation.next(chunk);) {
    for (const recording::ColumnInfo& info : recording::kColumns)
      append(recording[info.column], chunk[info.column]);
    for (std::size_t i = 0; i < result.effects_dph.size(); ++i) {
      append(result.effects_dph[i], chunk.effects_dph[i]);
    }
  }
  return result;
}

}  // namespace fogcomp::simulation
