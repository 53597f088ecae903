#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fit/known_regressors.hpp"
#include "fit/out_of_sample.hpp"

namespace fogcomp::fit {

/// With three or more runs leaves each out once, if the others determine all effects, the changed
/// ones not much worse than all runs do. Else leaves out stretches of time, a fifth of them at
/// once. A stretch is three times the correlation time of noise or residual, with 10 to 50
/// stretches in all, shorter where without one of them a changed effect is undetermined (the
/// warm-up of a single run) and the quiet parts tell the noise; parts without which even `before`
/// is undetermined do not count. `before`, `after`: identified on all of `series`. Each fold solves
/// for all coefficients again and for the shapes of after[i], i in `changed`; other shapes are
/// fixed.
OutOfSample cross_validate(const KnownRegressors& known,
                           const std::vector<model::EffectTerm>& before,
                           const std::vector<model::EffectTerm>& after,
                           const std::vector<std::size_t>& changed, const JudgedWith& with);

/// Rows that lie further from those fitted than stretches do, as those of another programme.
enum class FarRows {
  thirds,     ///< of every run
  directions  ///< heating, cooling
};
/// The same, with each of these parts left out once. A part counts if the others determine the
/// model, the changed terms not much worse than all rows do; nothing if none counts.
std::optional<OutOfSample> judge_far_rows(const KnownRegressors& known,
                                          const std::vector<model::EffectTerm>& before,
                                          const std::vector<model::EffectTerm>& after,
                                          const std::vector<std::size_t>& changed,
                                          const JudgedWith& with, FarRows parts);

/// Whether the runs but one determine the coefficients of after[i], i in `changed`, not much worse
/// than all runs do: only then can that one judge them. `after`: identified on all of `series`.
bool others_determine(const KnownRegressors& known, const std::vector<model::EffectTerm>& after,
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

/// First and second half, each left out once.
std::vector<HalfTest> judge_halves(const KnownRegressors& known,
                                   const std::vector<model::EffectTerm>& before,
                                   const std::vector<model::EffectTerm>& after,
                                   const std::vector<std::size_t>& changed, const JudgedWith& with);

}  // namespace fogcomp::fit
