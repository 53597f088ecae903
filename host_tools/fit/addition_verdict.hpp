#pragma once

#include <vector>

#include "fit/addition.hpp"
#include "fit/effect_change.hpp"
#include "runs/runs.hpp"

namespace fogcomp::fit {

/// Settings of every fit of an addition to `model`.
FitSettings fit_settings(const model::Model& model, const AddSettings& settings);

/// What a verdict is based on: a model without and with a change, fitted to the same rows.
struct FittedPair {
  const std::vector<model::EffectTerm>& given;  ///< for which the change was made
  const EffectChange& change;
  const KnownRegressors& known;       ///< of these rows
  const series::Rows& biases_before;  ///< the same rows without the cuts that are added
  const model::Model& before;
  const runs::Runs& runs;
  const AddSettings& settings;
};

/// Judges the effects alone, on data that were not fitted; cuts on stretches of their runs.
void judge_effects(const FittedPair& pair, Addition& after);
/// Compares with the same effects without the network: on the holdouts or, without any, by
/// cross-validation. A network that does not help is not kept.
void judge_network(const FittedPair& pair, Addition& after);
/// Sets verdict and reason from what judge_effects() or judge_network() found.
void decide(Addition& after);

}  // namespace fogcomp::fit
