#pragma once

#include <Eigen/Core>
#include <vector>

#include "series/term_columns.hpp"

namespace fogcomp::fit {

/// Inner products of columns and a residual, so that the chi^2 explained by any set of columns
/// needs only a small linear system, whatever the number of rows. Everything is whitened with the
/// model projected out; columns have unit length. They are of single precision, for their memory:
/// their rounding, another in each row, averages out in the inner products, which are of double.
class ExplainedSpace {
 public:
  explicit ExplainedSpace(Eigen::VectorXd residual) : residual_(std::move(residual)) {}

  /// The columns are not copied (they are most of a diagnosis' memory): they must stay as they are
  /// until finish().
  series::ColumnRange add(const Eigen::MatrixXf& columns);
  series::ColumnRange add(const Eigen::MatrixXf&& columns) = delete;
  /// To be called after the last add().
  void finish();

  const Eigen::MatrixXd& gram() const { return gram_; }
  /// Inner products of the columns with the residual.
  const Eigen::VectorXd& projection() const { return projection_; }

  /// The space with some columns treated as part of the noise, each with a coefficient of mean 0
  /// and its own variance > 0: inner products weighted by that noise.
  ExplainedSpace with_noise(const series::ColumnRange& random,
                            const Eigen::VectorXd& variances) const;
  /// The space with some columns projected out of the others and of the residual.
  ExplainedSpace without(const series::ColumnRange& part) const;
  /// Logarithm of the residual's likelihood with that noise less that without.
  double log_likelihood_of_noise(const series::ColumnRange& random,
                                 const Eigen::VectorXd& variances) const;

  /// Decrease of the residual's sum of squares by these columns together.
  double chi2_drop(const std::vector<series::ColumnRange>& parts) const;

 private:
  // R'R + 1/V of columns R that are noise of the variances V: its factor L.
  Eigen::MatrixXd root_of_noise(const series::ColumnRange& random,
                                const Eigen::VectorXd& variances) const;

  Eigen::VectorXd residual_;
  std::vector<const Eigen::MatrixXf*> parts_;  // until finish()
  Eigen::Index width_ = 0;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd projection_;
};

/// Logarithm of the evidence for `columns` regressors with a decrease of chi^2 of `chi2_drop`
/// against none: noise of unit variance, normal prior with the covariance of the regressors and the
/// most probable size (empirical Bayes). 0 for chi2_drop <= columns.
double log_evidence(double chi2_drop, double columns);

}  // namespace fogcomp::fit
