#pragma once

#include <cstddef>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/out_of_sample.hpp"

namespace fogcomp::fit {

/// Probability, 0..1, that a random walk of the bias explains what a change of effects explains, on
/// runs that were all fitted. `changed`: the terms of `after` that were added or changed.
double chance_of_walk_instead(const std::vector<model::EffectTerm>& before,
                              const std::vector<model::EffectTerm>& after,
                              const std::vector<std::size_t>& changed, const KnownRegressors& known,
                              const JudgedWith& with);

}  // namespace fogcomp::fit
