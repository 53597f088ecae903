#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::diagnosis {

/// Appends `added` to the terms, or replaces a smaller version of it.
void put(std::vector<model::EffectTerm>& terms, const model::EffectTerm& added);

/// Terms with least-squares coefficients, and the residual of each row.
struct Refit {
  std::vector<model::EffectTerm> terms;
  Eigen::VectorXd residual_dph;
};

/// Solves for the coefficients of `terms`, with fixed shapes, and for each run's own bias, with the
/// row weights of `fit` of the same `series`.
Refit refit(std::vector<model::EffectTerm> terms, const series::SignalSeries& series,
            const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
