#pragma once

#include <Eigen/Core>
#include <vector>

#include "series/term_columns.hpp"

namespace fogcomp::fit {

/// Columns and a residual as inner products, so that "how much would these columns explain
/// together?" costs a small linear system, whatever the number of rows. Everything in it is
/// whitened and free of what the model can do itself; columns have unit length.
class ExplainedSpace {
 public:
  explicit ExplainedSpace(Eigen::VectorXd residual) : residual_(std::move(residual)) {}

  series::ColumnRange add(const Eigen::MatrixXd& columns);
  /// After the last add().
  void finish();

  const Eigen::MatrixXd& gram() const { return gram_; }
  /// Inner products of the columns with the residual.
  const Eigen::VectorXd& projection() const { return projection_; }

  /// The space where some of its columns are part of the noise, each with a coefficient of mean 0
  /// and a variance of its own, above 0: the other columns and the residual as such noise weights
  /// them. `log_likelihood` of the residual is that with this noise less that without.
  struct WithNoise;
  WithNoise with_noise(const series::ColumnRange& random, const Eigen::VectorXd& variances) const;

  /// Fall of the residual's sum of squares that these columns bring together.
  double chi2_drop(const std::vector<series::ColumnRange>& parts) const {
    return chi2_drop(parts, projection_);
  }
  double chi2_drop(const std::vector<series::ColumnRange>& parts,
                   const Eigen::VectorXd& projection) const;
  /// Lower triangular; the square of its product with what is along these columns is their gain.
  Eigen::MatrixXd to_chi2_drop(const series::ColumnRange& part) const;
  /// Their coefficients, in the order of the parts, for columns of unit length.
  Eigen::VectorXd coefficients(const std::vector<series::ColumnRange>& parts) const;

 private:
  struct System {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd right;
  };
  System system(const std::vector<series::ColumnRange>& parts,
                const Eigen::VectorXd& projection) const;

  Eigen::VectorXd residual_;
  std::vector<Eigen::MatrixXd> pending_;
  Eigen::Index width_ = 0;
  Eigen::MatrixXd gram_;
  Eigen::VectorXd projection_;
};

struct ExplainedSpace::WithNoise {
  ExplainedSpace space;
  double log_likelihood = 0;
};

double column_count(const std::vector<series::ColumnRange>& ranges);

/// Logarithm of the evidence for `columns` regressors that explain `gain` (a fall of chi^2) against
/// none: unit-variance noise, coefficients with a normal prior in the shape of the regressors'
/// own covariance, of the size that suits the data best (empirical Bayes). 0 where gain <= columns.
double log_evidence(double chi2_drop, double columns);

}  // namespace fogcomp::fit
