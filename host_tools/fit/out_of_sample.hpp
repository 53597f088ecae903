#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "fit/decision_rules.hpp"
#include "fit/identify.hpp"
#include "model/model.hpp"
#include "runs/run.hpp"
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
  /// As clearly as an addition has to help: chi2_drop <= -rules::kMinChi2Drop.
  bool harms() const;
};

/// "0.0503 -> 0.0304 deg/h on the holdout (gain 83.4, needed 10)".
std::string out_of_sample_words(const OutOfSample& judged);

/// "it raises the error far from the rows fitted: 0.0484 -> 0.0929 deg/h on thirds of every run,
/// each left out once (gain -26.2)": a reason to refuse what harms().
std::string harm_words(const OutOfSample& judged);

/// Noise and row weights of one fit, with which two models are compared.
struct JudgedWith {
  const noise::NoiseModel& noise;
  const Eigen::VectorXd& row_weights;
  bool run_offsets = false;
};

/// `before`, `after`: residuals of two models on rows to which they were not fitted, one value per
/// row of `rows`. `weights`: 0 for excluded rows.
OutOfSample judge_residuals(const series::Rows& rows, const Eigen::VectorXd& before,
                            const Eigen::VectorXd& after, const noise::NoiseModel& noise,
                            const Eigen::VectorXd& weights);

/// In the models' rows. `holdouts`: at least one run that was used in neither fit. The models are
/// evaluated like on the board, clamped to the trained range. With run_offsets the mean of every
/// run is removed.
OutOfSample judge_on_holdouts(const model::Model& before, const model::Model& after,
                              const std::vector<runs::Run>& holdouts,
                              const noise::NoiseModel& noise, bool run_offsets);

}  // namespace fogcomp::fit
