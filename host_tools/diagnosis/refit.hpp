#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp {

/// Puts `added` behind the terms, in place of a smaller version of it among them.
void put(std::vector<EffectTerm>& terms, const EffectTerm& added);

/// Terms with the coefficients that fit best, and what they leave of each row.
struct Refit {
  std::vector<EffectTerm> terms;
  Eigen::VectorXd residual_dph;
};

/// Solves for the coefficients of `terms`, their shapes held, and of each run's own bias: rows
/// weighted as `fit` of the same `series` has them.
Refit refit(std::vector<EffectTerm> terms, const SignalSeries& series, const NoiseWeightedFit& fit);

}  // namespace fogcomp
