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

/// Two models on data that neither was fitted to.
struct OutOfSample {
  double rms_before_dph = 0;
  double rms_after_dph = 0;
  /// Fall of the sum of whitened squares, in units of what is left after: their variance times the
  /// number of neighbouring rows that go together. A set with one useless coefficient more scores
  /// about -1 +- 2; an effect that stands out by z standard deviations about z^2.
  double chi2_drop = 0;
  bool within_runs = false;  ///< on stretches between those that were fitted, not on other runs
  std::string how;           ///< e.g. "on stretches of 0.5 h, a fifth of them left out in turn"

  /// gain >= rules::kMinChi2Drop, and the plain error does not rise: the gain counts a row that is
  /// missed widely like one that is missed by four standard deviations.
  bool helps() const;
};

/// "0.0503 -> 0.0304 deg/h on the holdout (gain 83.4, needed 10)".
std::string out_of_sample_words(const OutOfSample& judged);

/// Both sets identified on one half in time of every run and judged on the other: the hardest
/// question, because a half may lack what the other is full of.
struct HalfTest {
  const char* identified_on = "";  ///< "first" or "second"
  bool determined = false;         ///< that half tells every coefficient, not far worse than all
  double rms_before_dph = 0;       ///< in the other half
  double rms_after_dph = 0;
};

/// One line that says how a half test went.
std::string half_words(const HalfTest& half);

/// What both sets are cross-validated with: the noise and row weights of one fit.
struct JudgedWith {
  const noise::NoiseModel& noise;
  const Eigen::VectorXd& row_weights;
  bool run_offsets = false;
};

/// Leaves every run out once where there are three or more and the others determine all effects,
/// the changed ones not much worse than all runs do. Else stretches of time, three times as long as
/// noise or residual go together (but 10 to 50 in all), every fifth of them at once; those without
/// which not even `before` is determined do not count. `before`, `after`: identified on all of
/// `series`; shapes stay as they are but for those of after[i], i in `changed`, which are searched
/// anew without the data left out, as are all coefficients.
OutOfSample cross_validate(const series::SignalSeries& series,
                           const std::vector<model::EffectTerm>& before,
                           const std::vector<model::EffectTerm>& after,
                           const std::vector<std::size_t>& changed, const JudgedWith& with);

/// Learns from the rows that have a weight, and says what it makes of all of them, deg/h.
using Learner = std::function<Eigen::VectorXd(const Eigen::VectorXd& row_weights)>;

/// Whether a learner helps where it did not learn: of 50 stretches of time every fifth is left out
/// at once, and what it makes of them is taken off `residual_dph`. The stretches are short,
/// whatever the noise remembers: a learner without a formula knows nothing of a ramp that it has
/// not seen, and the whitened squares hold no noise that the rows before a stretch could tell.
OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner);

/// First and second half, as cross_validate() would leave them out.
std::vector<HalfTest> judge_halves(const series::SignalSeries& series,
                                   const std::vector<model::EffectTerm>& before,
                                   const std::vector<model::EffectTerm>& after,
                                   const std::vector<std::size_t>& changed, const JudgedWith& with);

/// `holdouts`: runs that took no part in either fit; at least one. The models as the board has
/// them: clamped to the trained range. With run_offsets every run has its mean removed.
OutOfSample judge_on_holdouts(const model::Model& before, const model::Model& after,
                              const std::vector<compare::RunInBlocks>& holdouts,
                              const noise::NoiseModel& noise, bool run_offsets);

}  // namespace fogcomp::fit
