#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "noise/noise_model.hpp"

namespace fogcomp::diagnosis {

/// A chamber test that separates rivals.
struct Experiment {
  std::string profile;  ///< of `fogcomp simulate --profile`; "" where none of the menu does
  double hours = 0;
  double separation = 0;  ///< standard deviations by which the worse told pair would differ
  std::string sentence;   ///< for people
};

/// A rival extension of a model.
struct Rival {
  std::string effect;
  std::vector<model::EffectTerm> terms;   ///< with coefficients, the effect the last of them
  std::vector<model::EffectTerm> shapes;  ///< of the effect, that the recordings leave possible
};

/// Simulates all chamber programmes (fast, reversed, minor loops, random steps, heater, restarts,
/// axis flips...) for a typical gyro. For each, assumes one rival to be true as fitted and computes
/// how much of it another cannot imitate, in any possible shape and with all coefficients refitted.
/// Proposes the programme that maximises the smallest separation (in sigma) over all pairs of
/// rivals.
Experiment propose_experiment(const model::Model& model, const std::vector<Rival>& rivals,
                              const noise::NoiseModel& noise);

}  // namespace fogcomp::diagnosis
