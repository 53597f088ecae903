#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "fit/foretelling.hpp"
#include "fit/left_out_parts.hpp"
#include "judge/score.hpp"
#include "model/model.hpp"
#include "noise/noise_model.hpp"
#include "runs/run.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Comparison of two models on rows to which neither was fitted.
struct OutOfSample {
  double rms_before_dph = 0;  ///< of parts left out in turn: the geometric mean
  double rms_after_dph = 0;
  judge::Score score;
  judge::Promise promise;    ///< of the model after the change
  bool within_runs = false;  ///< on stretches of the fitted runs, not on other runs
  std::string how;           ///< e.g. "on stretches of 0.5 h, a fifth of them left out in turn"
};

/// Whether what is learnt without a formula, as by a network, foretells the rows better, and the
/// plain error does not rise.
bool helps(const OutOfSample& judged);

/// Whether the error rises without a gain, and is larger than the uncertainty of the model after
/// allows: not for want of rows that tell, but because the form is wrong there.
bool harms(const OutOfSample& judged);

/// "gain 83.4 +- 9.1, needed 4.6".
std::string gain_words(const judge::Score& score);

/// "0.0503 -> 0.0304 deg/h on the holdout (gain 83.4 +- 9.1, needed 4.6)".
std::string out_of_sample_words(const OutOfSample& judged);

/// `before`, `after`: what two models leave of rows to which they were not fitted, one value per
/// row of `rows`, put together from several fits perhaps; both in this noise. `weights`: 0 for
/// excluded rows.
OutOfSample judge_residuals(const series::Rows& rows, const Eigen::VectorXd& before,
                            const Eigen::VectorXd& after, const noise::NoiseModel& noise,
                            const Eigen::VectorXd& weights);

/// In the models' rows. `holdouts`: at least one run that was used in neither fit. The models are
/// evaluated like on the board, clamped to the trained range. With run_offsets the mean of every
/// run is removed.
OutOfSample judge_on_holdouts(const model::Model& before, const model::Model& after,
                              const std::vector<runs::Run>& holdouts,
                              const noise::NoiseModel& noise, bool run_offsets);

/// Two sets of effects, both fitted to all rows of `known`: which foretells rows that are left out
/// better? A shape that was sought costs the second set the logarithm of what could be chosen from.
class CrossValidation {
 public:
  /// `known` must outlive this.
  CrossValidation(const KnownRegressors& known, const JudgedEffects& before,
                  const JudgedEffects& after, const JudgedWith& with);

  /// Throws InputError if no row of the parts can be foretold.
  OutOfSample on(const Folds& folds) const;
  OutOfSample on(const FarPart& far) const;

  bool can_foretell(const Part& part) const { return after_.can_foretell(part); }

  /// On the rows from this one on.
  OutOfSample on_rows_from(std::size_t first) const;

  /// On each run, if there are three or more; else on stretches.
  OutOfSample on_runs_or_stretches() const;

 private:
  const series::Rows& rows_;
  const series::Rows& biases_before_;
  const series::Rows& biases_after_;
  Eigen::VectorXd weights_;
  bool run_offsets_ = false;
  Foretelling before_;
  Foretelling after_;
};

/// Learns from the rows with a weight > 0 and predicts all rows, deg/h.
using Learner = std::function<Eigen::VectorXd(const Eigen::VectorXd& row_weights)>;

/// Cross-validates a learner on stretches: its prediction for those left out is subtracted from
/// `residual_dph`.
OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner);

}  // namespace fogcomp::fit
