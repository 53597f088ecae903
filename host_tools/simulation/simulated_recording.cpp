#include "simulation/simulated_recording.hpp"

namespace fogcomp::simulation {
namespace {

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

SimulatedRecording record(Simulation& simulation, double period_s) {
  SimulatedRecording result;
  result.effects_dph.resize(simulation.effect_names().size());
  Recording& recording = result.recording;
  recording.period_s = period_s;
  recording.stretch_starts = {0};
  for (RowChunk chunk; simulation.next(chunk);) {
    append(recording.time_s, chunk.time_s);
    append(recording.temperature_degc, chunk.temperature_degc);
    append(recording.rate_dph, chunk.rate_dph);
    append(recording.input_rate_dph, chunk.input_rate_dph);
    append(recording.temperature2_degc, chunk.temperature2_degc);
    append(recording.magnetic_ut, chunk.magnetic_ut);
    append(recording.light_power_uw, chunk.light_power_uw);
    append(recording.supply_v, chunk.supply_v);
    append(recording.vibration_grms, chunk.vibration_grms);
    for (std::size_t i = 0; i < result.effects_dph.size(); ++i) {
      append(result.effects_dph[i], chunk.effects_dph[i]);
    }
  }
  return result;
}

}  // namespace fogcomp::simulation
