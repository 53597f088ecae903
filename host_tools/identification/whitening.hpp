#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/noise_model.hpp"
#include "identification/signal_series.hpp"

namespace fogcomp {

/// Turns rows with coloured noise into rows with white noise of variance 1: the scaled innovations
/// of the Kalman filter that belongs to a noise model. Linear, so the same filter serves
/// measurements and regressors; O(rows), gaps and rows of different weight allowed; each recording
/// begins anew. A row of weight 0 is left out: it becomes 0 and tells nothing about its neighbours.
class Whitening {
 public:
  Whitening(const NoiseModel& noise, const Rows& rows, const Eigen::VectorXd& weights);

  /// Every column of `matrix` (rows x any).
  Eigen::MatrixXd apply(const Eigen::MatrixXd& matrix) const;

 private:
  Eigen::MatrixXd decay_;  // components x rows: from the row before to this one
  Eigen::MatrixXd gain_;   // components x rows
  Eigen::VectorXd scale_;  // 1 / standard deviation of each innovation
};

}  // namespace fogcomp
