#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/departure.hpp"
#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/prior.hpp"

namespace fogcomp::fit {

/// A fit with a prior, and what it changed of it.
struct InformedFit {
  NoiseWeightedFit fit;               ///< its prior is as wide as the rows made it
  std::vector<Departure> departures;  ///< of each of the prior's unknowns, by the gyro's reading
  Seen seen;                          ///< what the rows alone say of them, by the same reading
  /// Of each: its value for a board less the gyro's own.
  Eigen::VectorXd board_less_gyro;
};

/// Fits the prior's terms, as fit_determined() fits others, and the nuisance columns. The noise is
/// the prior's, or more if the rows have more: a short run hardly tells slow noise from effects. An
/// unknown that the rows show to be unlike the prior is let go of (departure.hpp).
InformedFit fit_with_prior(const KnownRegressors& known, const Prior& prior,
                           const Eigen::MatrixXd& nuisance,
                           const std::function<void(double)>& progress = {});

}  // namespace fogcomp::fit
