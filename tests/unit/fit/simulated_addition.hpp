#pragma once

#include "fit/add_effect.hpp"
#include "fit/effect_change.hpp"
#include "model/effect_list.hpp"
#include "unit/fit/simulated_gyro.hpp"

namespace fog::test {

constexpr RowNoise kAdditionNoise{0.024, 0.006, 300};

/// All that truth() has.
inline const char* const kComplete = "bias,bias_temperature:order=3,temperature_rate";

/// The model of truth() with `effects` in place of its own.
inline fogcomp::model::Model incomplete(const std::string& effects) {
  return model_of(fogcomp::model::parse_effects(effects));
}

inline fogcomp::compare::RunInBlocks run_of(const fogcomp::model::Model& gyro, std::uint64_t seed) {
  return fogcomp::compare::run_in_blocks(recording_of(gyro, kAdditionNoise, seed), 10);
}

/// One run of `gyro` for each seed.
inline fogcomp::fit::TrainingRuns runs_of(const fogcomp::model::Model& gyro,
                                          const std::vector<std::uint64_t>& seeds) {
  fogcomp::fit::TrainingRuns training;
  for (const std::uint64_t seed : seeds) training.runs.push_back(run_of(gyro, seed));
  if (!training.runs.empty()) training.noise_floor_dph = training.runs[0].noise_floor_dph;
  training.noise_dph_rthz = 0.075;
  return training;
}

/// `effect` added to a model of `effects` by runs of `gyro`.
inline fogcomp::fit::Addition add(const std::string& effects, const std::string& effect,
                                  const fogcomp::model::Model& gyro,
                                  const std::vector<std::uint64_t>& seeds,
                                  const std::vector<fogcomp::compare::RunInBlocks>& holdouts = {}) {
  const fogcomp::model::Model given = incomplete(effects);
  return add_effect(given, fogcomp::fit::change_effect(given.terms, effect), runs_of(gyro, seeds),
                    holdouts, {});
}

}  // namespace fog::test
