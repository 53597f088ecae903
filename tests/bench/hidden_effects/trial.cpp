#include "trial.hpp"

#include <utility>

#include "simulation/embedded_files.hpp"
#include "simulation/programme.hpp"
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
    // Contributions of an effect are one column; its declared part must not count as hidden.
    options.push_back(hidden ? option.substr(0, option.find(':')) + ":slope=0,curvature=0"
                             : option);
  }
  for (const HiddenEffect& effect : plan.hidden) options.push_back(effect.option(effect.natural));
  for (const std::string& option : options) gyro.apply_option("case", option);
  return gyro;
}

}  // namespace

TrialRun simulate_trial(const CasePlan& plan, const PlannedRun& run) {
  const GyroDescription gyro = natural_gyro(plan);
  SimulationOptions options;
  options.seed = run.seed;
  options.rate_hz = plan.rate_hz;
  options.earth.latitude_deg = plan.latitude_deg;
  const Programme programme = parse_profile(
      find_text(run.programme, ready_made_profiles(), "profile"), run.programme, run.seed);
  Simulation simulation(gyro, programme, options);

  SimulatedRecording recorded = record(simulation, 1 / options.rate_hz);
  recorded.recording.file = run.name;
  return {std::move(recorded.recording), simulation.effect_names(),
          std::move(recorded.effects_dph)};
}

}  // namespace fogcomp::bench
