#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// What whitening makes of a column that is 0 before a row and 1 from it to the end of its
/// recording, for every row at once.
struct StepProducts {
  Eigen::VectorXd square;  ///< per row: its sum of squares
  Eigen::MatrixXd with;    ///< rows x columns: its product with each of some whitened columns
};

/// Turns rows with coloured noise into rows with white noise of variance 1: the scaled innovations
/// of the Kalman filter that belongs to a noise model. Linear, so the same filter serves
/// measurements and regressors; O(rows), gaps and rows of different weight allowed; each recording
/// begins anew. A row of weight 0 is left out: it becomes 0 and tells nothing about its neighbours.
class Whitening {
 public:
  Whitening(const NoiseModel& noise, const series::Rows& rows, const Eigen::VectorXd& weights);

  /// Every column of `matrix` (rows x any).
  Eigen::MatrixXd apply(const Eigen::MatrixXd& matrix) const;

  /// With apply() the product of a matrix from the left: the product of its transpose.
  Eigen::MatrixXd apply_transposed(const Eigen::MatrixXd& matrix) const;

  /// `rows` are those of the constructor; `whitened` is rows x any. O(rows).
  StepProducts steps(const series::Rows& rows, const Eigen::MatrixXd& whitened) const;

 private:
  /// Columns `first` to `first + kColumns` of `matrix` into those of `white`.
  template <int kColumns>
  void filter(const Eigen::MatrixXd& matrix, Eigen::Index first, Eigen::MatrixXd& white) const;

  Eigen::MatrixXd decay_;  // components x rows: from the row before to this one
  Eigen::MatrixXd gain_;   // components x rows
  Eigen::VectorXd scale_;  // 1 / standard deviation of each innovation
};

}  // namespace fogcomp::noise
