#pragma once

#include <Eigen/Core>

#include "diagnosis/candidates.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "noise/whitening.hpp"

namespace fogcomp::diagnosis {

/// Projects out of whitened columns what a fitted model could describe: its coefficients, small
/// changes of its shape parameters, and errors of its terms: a sensor a little early or late,
/// layers with other lags, a formula that bends a little with temperature.
class Residualizer {
 public:
  Residualizer(const series::Rows& rows, const fit::NoiseWeightedFit& fit);

  /// Whitened, without the model; has a few more rows than the input, because prior knowledge acts
  /// like additional measurements.
  VisiblePart operator()(const Eigen::MatrixXd& regressors) const;
  /// Whitened residual of the model.
  const Eigen::VectorXd& residual() const { return residual_; }
  const noise::Whitening& whitening() const { return whitening_; }
  /// Possible errors of the model's terms, rows x any number, each of one standard deviation.
  const Eigen::MatrixXd& inexact() const { return inexact_; }
  /// Fall of the squares of `left`, any number of whitened residuals without the model, by a step
  /// at each row: one per row and residual. 0 where less than rules::kMinVisible of the step is
  /// visible. O(rows).
  Eigen::MatrixXd chi2_drops_of_steps(const series::Rows& rows, const Eigen::MatrixXd& left) const;

 private:
  Eigen::MatrixXd with_priors(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd without_model(const Eigen::MatrixXd& columns) const;

  noise::Whitening whitening_;
  Eigen::MatrixXd inexact_;
  Eigen::Index priors_ = 0;  // rows of prior knowledge
  Eigen::MatrixXd basis_;    // orthonormal
  Eigen::VectorXd residual_;
};

}  // namespace fogcomp::diagnosis
