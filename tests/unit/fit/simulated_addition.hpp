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

inline fogcomp::runs::Run run_of(const fogcomp::model::Model& gyro, std::uint64_t seed) {
  return fogcomp::runs::run_of(recording_of(gyro, kAdditionNoise, seed), {10});
}

/// One run of `gyro` for each seed.
inline fogcomp::runs::Runs runs_of(const fogcomp::model::Model& gyro,
                                   const std::vector<std::uint64_t>& seeds) {
  fogcomp::runs::Runs runs;
  for (const std::uint64_t seed : seeds) runs.training.push_back(run_of(gyro, seed));
  runs.noise_dph_rthz = 0.075;
  return runs;
}

/// `effect` added to a model of `effects` by runs of `gyro`.
inline fogcomp::fit::Addition add(const std::string& effects, const std::string& effect,
                                  const fogcomp::model::Model& gyro,
                                  const std::vector<std::uint64_t>& seeds,
                                  const std::vector<fogcomp::runs::Run>& holdouts = {}) {
  const fogcomp::model::Model given = incomplete(effects);
  fogcomp::runs::Runs runs = runs_of(gyro, seeds);
  runs.holdouts = holdouts;
  return add_effect(given, fogcomp::fit::change_effect(given.terms, effect), runs, {});
}

}  // namespace fog::test
