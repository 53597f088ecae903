#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "fit/decision_rules.hpp"
#include "fit/identify.hpp"
#include "model/model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::fit {

/// Comparison of two models on data to which neither was fitted.
struct OutOfSample {
  double rms_before_dph = 0;
  double rms_after_dph = 0;
  /// Decrease of the whitened sum of squares, in units of what is left: its variance times the
  /// number of correlated neighbouring rows. A set with one useless coefficient scores about -1 +-
  /// 2, an effect of z standard deviations about z^2.
  double chi2_drop = 0;
  bool within_runs = false;  ///< on stretches of the fitted runs, not on other runs
  std::string how;           ///< e.g. "on stretches of 0.5 h, a fifth of them left out in turn"

  /// chi2_drop >= rules::kMinChi2Drop, and the plain error does not rise. The latter is needed
  /// because chi2_drop counts any large deviation like four standard deviations.
  bool helps() const;
};

/// "0.0503 -> 0.0304 deg/h on the holdout (gain 83.4, needed 10)".
std::string out_of_sample_words(const OutOfSample& judged);

/// Both sets identified on one half (in time) of every run and judged on the other: the hardest
/// test, because a half may lack excitation that the other has.
struct HalfTest {
  const char* identified_on = "";  ///< "first" or "second"
  bool determined = false;    ///< that half determines every coefficient about as well as all rows
  double rms_before_dph = 0;  ///< in the other half
  double rms_after_dph = 0;
};

/// One line with the result of a half test.
std::string half_words(const HalfTest& half);

/// Data for a cross-validation of both sets: noise and row weights of one fit.
struct JudgedWith {
  const noise::NoiseModel& noise;
  const Eigen::VectorXd& row_weights;
  bool run_offsets = false;
};

/// With three or more runs leaves each out once, if the others determine all effects, the changed
/// ones not much worse than all runs do. Else leaves out stretches of time, a fifth of them at
/// once. A stretch is three times the correlation time of noise or residual, with 10 to 50
/// stretches in all; parts without which even `before` is undetermined do not count. `before`,
/// `after`: identified on all of `series`. Each fold solves for all coefficients again and for the
/// shapes of after[i], i in `changed`; other shapes are fixed.
OutOfSample cross_validate(const series::SignalSeries& series,
                           const std::vector<model::EffectTerm>& before,
                           const std::vector<model::EffectTerm>& after,
                           const std::vector<std::size_t>& changed, const JudgedWith& with);

/// Whether the runs but one determine the coefficients of after[i], i in `changed`, not much worse
/// than all runs do: only then can that one judge them. `after`: identified on all of `series`.
bool others_determine(const series::SignalSeries& series,
                      const std::vector<model::EffectTerm>& after,
                      const std::vector<std::size_t>& changed, std::size_t run,
                      const JudgedWith& with);

/// Learns from the rows with a weight > 0 and predicts all rows, deg/h.
using Learner = std::function<Eigen::VectorXd(const Eigen::VectorXd& row_weights)>;

/// Cross-validates a learner: every fifth of 50 stretches of time is left out at once, and the
/// prediction for it is subtracted from `residual_dph`. The stretches are short whatever the memory
/// of the noise, because a learner without a formula cannot predict a ramp that it has not seen,
/// and whitening removes the noise that preceding rows could predict.
OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner);

/// First and second half, each left out once.
std::vector<HalfTest> judge_halves(const series::SignalSeries& series,
                                   const std::vector<model::EffectTerm>& before,
                                   const std::vector<model::EffectTerm>& after,
                                   const std::vector<std::size_t>& changed, const JudgedWith& with);

/// `holdouts`: at least one run that was used in neither fit. The models are evaluated like on the
/// board, clamped to the trained range. With run_offsets the mean of every run is removed.
OutOfSample judge_on_holdouts(const model::Model& before, const model::Model& after,
                              const std::vector<compare::RunInBlocks>& holdouts,
                              const noise::NoiseModel& noise, bool run_offsets);

}  // namespace fogcomp::fit
