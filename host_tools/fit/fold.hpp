#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/left_out_parts.hpp"
#include "fit/out_of_sample.hpp"
#include "noise/whitening.hpp"

namespace fogcomp::fit {

/// The rows that remain when a part is left out, for fits of several sets of effects to them.
struct RemainingRows {
  RemainingRows(const KnownRegressors& known, const Part& left_out, const JudgedWith& with);

  bool all;                 ///< nothing is left out
  Eigen::VectorXd weights;  ///< 0 for those left out
  noise::Whitening whitening;
  Eigen::MatrixXd offsets;  ///< biases of power-ons, if each has its own
};

/// A set of effects, identified without some of the rows.
struct Fold {
  std::vector<model::EffectTerm> terms;  ///< with the shapes of this fit
  Eigen::VectorXd residual_dph;          ///< in all rows
  bool determined = false;               ///< the rows that are left determine every coefficient
  /// Of the terms' coefficients, if determined; biases of power-ons differ from fold to fold.
  Eigen::VectorXd sigma_dph;
};

/// Solves for all coefficients of `terms` and, if anything is left out, for those of their shapes
/// that are identified: with all rows the fit that is judged has found them.
Fold fit_to(const RemainingRows& remaining, const KnownRegressors& known,
            const std::vector<model::EffectTerm>& terms, const JudgedWith& with);

/// Standard deviation of what a fold of these rows predicts in each row, deg/h, by the uncertainty
/// of its coefficients and shapes, with noise as strong and as long as what the fit leaves.
/// Infinite if the fold is not determined.
Eigen::VectorXd prediction_sigma_dph(const KnownRegressors& known, const Fold& fold,
                                     const RemainingRows& remaining);

/// Whether the rows of `fold` determine every term's coefficient not far worse than all rows do
/// (rules::kFarWorse times their sigma).
bool determines_all(const Fold& fold, const Fold& all);

/// Whether they determine terms[i], i in `asked`, not much worse (rules::kMuchWorse).
bool determines_terms(const Fold& fold, const Fold& all, const KnownRegressors& known,
                      const std::vector<model::EffectTerm>& terms,
                      const std::vector<std::size_t>& asked);

/// Whether the runs but one determine after[i], i in `changed`, not much worse than all runs do:
/// only then can that one judge them. `after`: identified on all rows.
bool others_determine(const KnownRegressors& known, const std::vector<model::EffectTerm>& after,
                      const std::vector<std::size_t>& changed, std::size_t run,
                      const JudgedWith& with);

}  // namespace fogcomp::fit
