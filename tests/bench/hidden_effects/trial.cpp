#include "trial.hpp"

#include "simulation/embedded_files.hpp"
#include "simulation/profile_parser.hpp"
#include "simulation/simulation.hpp"

namespace fogcomp::bench {
namespace {

using namespace simulation;

bool concerns(const std::string& option, const std::string& effect) {
  return option.compare(0, effect.size() + 1, effect + ":") == 0;
}

GyroDescription natural_gyro(const CasePlan& plan) {
  GyroDescription gyro;
  std::vector<std::string> options = plan.gyro.parts;
  for (const std::string& option : plan.gyro.effects) {
    bool hidden = false;
    for (const HiddenEffect& effect : plan.hidden) hidden = hidden || concerns(option, effect.name);
    // Contributions of one effect come in one column; its declared part must not count as hidden.
    options.push_back(hidden ? option.substr(0, option.find(':')) + ":slope=0,curvature=0"
                             : option);
  }
  for (const HiddenEffect& effect : plan.hidden) options.push_back(effect.option(effect.natural));
  for (const std::string& option : options) apply_option(gyro, "case", option);
  return gyro;
}

void append(std::vector<double>& all, const std::vector<double>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

TrialRun simulate_trial(const CasePlan& plan, const PlannedRun& run) {
  const GyroDescription gyro = natural_gyro(plan);
  SimulationOptions options;
  options.seed = run.seed;
  options.earth.latitude_deg = plan.latitude_deg;
  const Programme programme = parse_profile(
      find_text(run.programme, ready_made_profiles(), "profile"), run.programme, run.seed);
  Simulation simulation(gyro, programme, options);

  TrialRun trial;
  trial.effects = simulation.effect_names();
  trial.contributions_dph.resize(trial.effects.size());
  Recording& recording = trial.recording;
  recording.file = run.name;
  recording.period_s = 1 / options.rate_hz;
  RowChunk chunk;
  while (simulation.next(chunk)) {
    append(recording.time_s, chunk.time_s);
    append(recording.temperature_degc, chunk.temperature_degc);
    append(recording.rate_dph, chunk.rate_dph);
    append(recording.input_rate_dph, chunk.input_rate_dph);
    append(recording.temperature2_degc, chunk.temperature2_degc);
    append(recording.magnetic_ut, chunk.magnetic_ut);
    append(recording.light_power_uw, chunk.light_power_uw);
    append(recording.supply_v, chunk.supply_v);
    append(recording.vibration_grms, chunk.vibration_grms);
    for (std::size_t i = 0; i < trial.effects.size(); ++i) {
      append(trial.contributions_dph[i], chunk.effects_dph[i]);
    }
  }
  recording.stretch_starts = {0};
  return trial;
}

}  // namespace fogcomp::bench
