#pragma once

#include <Eigen/Core>

#include "diagnosis/candidates.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "noise/whitening.hpp"

namespace fogcomp::diagnosis {

/// Takes out of whitened columns what a fitted model could do itself: its coefficients, small
/// changes of its shape parameters, and that its terms are not exactly what the coil does: a sensor
/// a little early or late, layers that follow with other lags, a formula that bends a little more
/// with temperature.
class Residualizer {
 public:
  Residualizer(const series::Rows& rows, const fit::NoiseWeightedFit& fit);

  /// Whitened, without the model; a few rows more than given (what is known beforehand is
  /// like a few more measurements).
  VisiblePart operator()(const Eigen::MatrixXd& regressors) const;
  /// What the model leaves of the measurement.
  const Eigen::VectorXd& residual() const { return residual_; }
  const noise::Whitening& whitening() const { return whitening_; }

 private:
  Eigen::MatrixXd with_priors(const Eigen::MatrixXd& columns) const;
  Eigen::MatrixXd without_model(const Eigen::MatrixXd& columns) const;

  noise::Whitening whitening_;
  Eigen::Index priors_ = 0;  // rows for what is known beforehand
  Eigen::MatrixXd basis_;    // orthonormal
  Eigen::VectorXd residual_;
};

}  // namespace fogcomp::diagnosis
