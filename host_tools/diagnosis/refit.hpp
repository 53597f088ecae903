#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::diagnosis {

/// Puts `added` behind the terms, in place of a smaller version of it among them.
void put(std::vector<model::EffectTerm>& terms, const model::EffectTerm& added);

/// Terms with the coefficients that fit best, and what they leave of each row.
struct Refit {
  std::vector<model::EffectTerm> terms;
  Eigen::VectorXd residual_dph;
};

/// Solves for the coefficients of `terms`, their shapes held, and of each run's own bias: rows
/// weighted as `fit` of the same `series` has them.
Refit refit(std::vector<model::EffectTerm> terms, const series::SignalSeries& series,
            const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
