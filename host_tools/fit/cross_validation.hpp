#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/fold.hpp"
#include "fit/known_regressors.hpp"
#include "fit/out_of_sample.hpp"

namespace fogcomp::fit {

/// Rows that lie further from those fitted than stretches do, as those of another programme.
enum class FarRows {
  thirds,     ///< of every run
  directions  ///< heating, cooling
};

/// The coldest, the middle and the warmest third of the rows, each left out once: what is wrong
/// there, at temperatures that were not fitted, is slow, which OutOfSample::chi2_drop hardly
/// counts.
struct TemperatureTest {
  std::optional<OutOfSample> judged;  ///< as for FarRows
  /// In all thirds, however little the other rows determine.
  double rms_before_dph = 0;
  double rms_after_dph = 0;
  /// By what the second set leaves of all rows and by the uncertainty of its coefficients and
  /// shapes; 0 if the error does not rise.
  double rms_expected_dph = 0;

  /// The error rises to more than rules::kBeyondExpected times what is expected: not for want of
  /// rows, but because the form is wrong.
  bool fails() const;
};

/// "it fails at temperatures that were not fitted: 0.157 -> 0.471 deg/h in thirds of them left out,
/// where 0.0883 were to be expected".
std::string failure_words(const TemperatureTest& test);

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

/// Two sets of effects, identified without parts of the rows and judged there. Each fold solves for
/// all coefficients again and for the shapes of the changed terms; other shapes are fixed. A part
/// without which the rows do not determine both sets does not count (a polynomial without the only
/// run that is cold).
class CrossValidation {
 public:
  /// `before`, `after`: identified on all rows of `known`. `changed`: positions of the terms of
  /// `after` that `before` lacks. `known` and `with` must outlive this.
  CrossValidation(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                  const std::vector<model::EffectTerm>& after, std::vector<std::size_t> changed,
                  const JudgedWith& with);

  /// With three or more runs each run, if the others determine the changed terms not much worse
  /// than all do. Else stretches of time, a fifth of them at once: each three times as long as the
  /// noise or the residual correlates, 10 to 50 in all, shorter where without one of them a changed
  /// term is undetermined (the warm-up of a single run) and the quiet parts tell the noise.
  OutOfSample on_runs_or_stretches() const;

  /// Those parts that determine the changed terms not much worse than all rows do; nothing if none
  /// does.
  std::optional<OutOfSample> on_far_rows(FarRows far) const;

  TemperatureTest on_temperatures() const;

  /// First and second half.
  std::vector<HalfTest> on_halves() const;

 private:
  // Folds of both sets.
  struct Pair {
    Fold before;
    Fold after;
  };
  struct LeftOut;

  LeftOut leave_out_each(std::vector<Part> parts) const;
  std::optional<LeftOut> leave_out_if_determined(std::vector<Part> parts) const;
  void fit_after(std::size_t part, LeftOut& left) const;
  void fit_before(std::size_t part, LeftOut& left) const;
  bool determine_changed(const Fold& after) const;
  bool all_determine_changed(const LeftOut& left) const;
  OutOfSample judge(const LeftOut& left, const std::vector<bool>& judges, std::string how) const;
  std::optional<OutOfSample> judge_far(const LeftOut& left, std::string how) const;
  std::optional<OutOfSample> on_runs() const;
  OutOfSample on_stretches(double count) const;

  const KnownRegressors& known_;
  const series::Rows& rows_;
  std::vector<model::EffectTerm> before_;
  std::vector<model::EffectTerm> after_;
  std::vector<std::size_t> changed_;
  const JudgedWith& with_;
  Pair all_;  // with all rows
};

/// Learns from the rows with a weight > 0 and predicts all rows, deg/h.
using Learner = std::function<Eigen::VectorXd(const Eigen::VectorXd& row_weights)>;

/// Cross-validates a learner: every fifth of 50 stretches of time is left out at once, and the
/// prediction for it is subtracted from `residual_dph`. The stretches are short whatever the memory
/// of the noise, because a learner without a formula cannot predict a ramp that it has not seen,
/// and whitening removes the noise that preceding rows could predict.
OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner);

}  // namespace fogcomp::fit
