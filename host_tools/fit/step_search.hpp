#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/noise_weighted_fit.hpp"
#include "noise/change_points.hpp"

namespace fogcomp::fit {

/// A fit with the bias steps that it found: their columns are the last of the nuisance.
struct FitWithSteps {
  NoiseWeightedFit fit;
  std::vector<noise::ChangePoint> steps;  ///< in the order of the columns; size and time as located
  std::size_t masked = 0;                 ///< rows left out because a jump lies in them
};

/// Fits without a step, then with one more as long as the best further place lowers chi^2, in units
/// of the noise that is left then, by more than 60: flicker noise imitates smaller ones. It must do
/// so beside cosines over hours, so that slow drift which the model lacks is no step, and every
/// step must still do so in the fit with all of them. The noise that judges a step is estimated
/// with that step already taken out. Rows in which a jump may lie count for nothing. At most
/// `max_steps`. `progress` is told how much of the first fit is done, 0..1.
FitWithSteps fit_with_steps(const series::SignalSeries& series,
                            const std::vector<model::EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance, std::size_t max_steps,
                            const std::function<void(double)>& progress);

}  // namespace fogcomp::fit
