#pragma once

#include <vector>

#include "fit/explained_space.hpp"
#include "noise/noise_model.hpp"
#include "noise/whitening.hpp"
#include "series/rows.hpp"

namespace fogcomp::fit {

/// A random walk of the bias as the only cause of a residual.
struct WalkRival {
  double coefficient = 0;  ///< of the most probable walk, deg/h/sqrt(h); 0: none
  double log_odds = 0;     ///< ln of the odds of any walk against noise without one
  ExplainedSpace space;    ///< with the most probable walk as part of the noise
};

/// Columns of a random walk's modes in a space, scaled to unit length.
struct WalkModes {
  series::ColumnRange columns;
  Eigen::VectorXd square;  ///< of their original lengths
};
/// Columns of a random walk (noise::random_walk_modes) as far as one that the quiet parts do not
/// exclude is visible.
Eigen::MatrixXf visible_walk_modes(const series::Rows& rows, const noise::NoiseModel& noise);

/// `modes`: visible_walk_modes(), whitened, model projected out. Those within the model are
/// removed, the others scaled to unit length; they must stay as they are then until space.finish().
WalkModes add_walk(ExplainedSpace& space, Eigen::MatrixXf& modes);

/// Most probable walk according to the quiet parts (`walks`) and `space`. Prior: a walk is as
/// probable as none, all of `walks` equally. Walks excluded by the quiet parts are not considered.
WalkRival find_walk(const ExplainedSpace& space, const WalkModes& modes,
                    const std::vector<noise::NoiseModel::Walk>& walks);

/// Effects that explain a part of the residual.
struct Explanatory {
  double log_evidence = 0;  ///< against noise alone
  double log_prior = 0;     ///< prior odds against "nothing is missing"
};

/// Probability, 0..1, that nothing is missing and all is noise with a random walk, against effects
/// without a walk and effects beside the most probable walk.
double chance_of_walk(const WalkRival& rival, const std::vector<Explanatory>& alone,
                      const std::vector<Explanatory>& beside);

/// The same for columns added to a linear model. All whitened with `noise`: `before` and `added`
/// are rows x any number, `measured` has a value per row.
struct AddedColumns {
  Eigen::MatrixXd before;
  Eigen::MatrixXd added;
  Eigen::VectorXd measured;
};
double chance_of_walk(const series::Rows& rows, const noise::NoiseModel& noise,
                      const noise::Whitening& whitening, const AddedColumns& columns);

}  // namespace fogcomp::fit
