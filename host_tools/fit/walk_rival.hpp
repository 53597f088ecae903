#pragma once

#include <vector>

#include "fit/explained_space.hpp"
#include "noise/noise_model.hpp"

namespace fogcomp::fit {

/// A random walk of the bias as the reason for what a model leaves: no effect at all.
struct WalkRival {
  double coefficient = 0;  ///< of the likeliest walk, deg/h/sqrt(h); 0: none
  double log_odds = 0;     ///< ln of the odds of it against noise without a walk
  ExplainedSpace space;    ///< with the likeliest walk as part of the noise
};

/// Where the modes of a random walk lie in a space, made one long there.
struct WalkModes {
  series::ColumnRange columns;
  Eigen::VectorXd square;  ///< of their own lengths
};
/// `modes`: random_walk_modes(), whitened and without the model. Modes that the model can do itself
/// are left out.
WalkModes add_walk(ExplainedSpace& space, const Eigen::MatrixXd& modes);

/// The walk that is likeliest by the quiet parts (`walks`) and by what `space` holds. Beforehand a
/// walk is as likely as none, and each of `walks` as the others; what the quiet parts rule out is
/// none.
WalkRival find_walk(const ExplainedSpace& space, const WalkModes& modes,
                    const std::vector<noise::NoiseModel::Walk>& walks);

/// Effects that explain something of what is left.
struct Explanatory {
  double log_evidence = 0;  ///< against noise alone
  double log_prior = 0;     ///< how likely they are beforehand, against "nothing is missing"
};

/// Chance that nothing is missing and all is noise with a random walk, 0..1, against effects
/// without a walk, and beside the likeliest one.
double chance_of_walk(const WalkRival& rival, const std::vector<Explanatory>& alone,
                      const std::vector<Explanatory>& beside);

/// The same for columns that are added to a linear model, on rows x any that are whitened with
/// `noise` and `row_weights`. `before`, `added` and `measured`: not whitened.
double chance_of_walk(const series::Rows& rows, const noise::NoiseModel& noise,
                      const Eigen::VectorXd& row_weights, const Eigen::MatrixXd& before,
                      const Eigen::MatrixXd& added, const Eigen::VectorXd& measured);

}  // namespace fogcomp::fit
