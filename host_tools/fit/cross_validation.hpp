#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "fit/foretelling.hpp"
#include "fit/left_out_parts.hpp"
#include "fit/out_of_sample.hpp"

namespace fogcomp::fit {

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
