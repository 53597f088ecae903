#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "noise/change_points.hpp"

namespace fogcomp::fit {

/// A bias step that a fit found. It belongs to one recording.
struct FoundStep {
  std::size_t run = 0;  ///< recording, from 0
  double time_s = 0;    ///< since power-on
  double time_sigma_s = 0;
  double size_dph = 0;
  double size_sigma_dph = 0;
  double others_part = 0;  ///< as in model::EffectTerm
};

/// A bias step, as first located.
struct LocatedStep {
  noise::ChangePoint change;
  double others_part = 0;  ///< as in model::EffectTerm
};

/// A fit with the bias steps that it found; they are the last nuisance columns.
struct FitWithSteps {
  NoiseWeightedFit fit;
  std::vector<LocatedStep> steps;  ///< in the order of the columns
  std::size_t masked = 0;          ///< rows excluded because a step lies in them
};

/// Fits without steps, then adds steps while the best further position lowers chi^2, in units of
/// the remaining noise, by more than 60 (flicker noise imitates smaller ones). It must do so beside
/// cosines over hours, so that a slow drift that the model lacks is no step, and no change over
/// minutes may explain clearly more; and every step must still lower it in the fit with all of
/// them. The noise that judges a step is estimated with the step removed. Rows that may contain a
/// step have weight 0. At most `max_steps`. Whether the other recordings have the bias from before
/// a step or the one that follows it is what fits better; where there are none, or each has its own
/// bias, the last is what the gyro goes on with. Of two steps and more they have the mean of each
/// recording, unless one without a step tells another bias: what steps again may step back (random
/// telegraph signal, mode hops), so that the last level is not what to expect. `progress` is called
/// with the fraction of the first fit done, 0..1.
FitWithSteps fit_with_steps(const KnownRegressors& known,
                            const std::vector<model::EffectTerm>& terms,
                            const Eigen::MatrixXd& nuisance, std::size_t max_steps,
                            const std::function<void(double)>& progress);

/// Fits with steps that are known. Rows that may contain one have weight 0.
FitWithSteps fit_at_steps(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
                          const Eigen::MatrixXd& nuisance, const std::vector<FoundStep>& steps,
                          const std::function<void(double)>& progress);

}  // namespace fogcomp::fit
