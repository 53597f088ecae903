#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/noise_model.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::noise {

/// Statistics of the whitened step (0 before a row, 1 from it to the end of its recording) for
/// every row at once.
struct StepProducts {
  Eigen::VectorXd square;  ///< per row: its sum of squares
  Eigen::MatrixXd with;    ///< rows x columns: its product with each given whitened column
};

/// Turns rows with coloured noise into rows with white noise of variance 1: the scaled innovations
/// of the Kalman filter of a noise model. Linear, so the same filter serves measurements and
/// regressors; O(rows). Handles gaps and rows of different weight; each recording starts anew. A
/// row of weight 0 is skipped: its result is 0, and it does not affect its neighbours.
class Whitening {
 public:
  Whitening(const NoiseModel& noise, const series::Rows& rows, const Eigen::VectorXd& weights);

  /// 1 / standard deviation of each row, given those before it; (deg/h)^-1.
  const Eigen::VectorXd& scale() const { return scale_; }

  /// Whitens every column of `matrix` (rows x any number).
  Eigen::MatrixXd apply(const Eigen::MatrixXd& matrix) const;

  /// `rows`: those of the constructor; `whitened`: rows x any number. O(rows).
  StepProducts steps(const series::Rows& rows, const Eigen::MatrixXd& whitened) const;

 private:
  /// Whitens columns `first` to `first + kColumns` of `matrix` into those of `white`.
  template <int kColumns>
  void filter(const Eigen::MatrixXd& matrix, Eigen::Index first, Eigen::MatrixXd& white) const;

  Eigen::MatrixXd decay_;  // components x rows: from the row before to this one
  Eigen::MatrixXd gain_;   // components x rows
  // What the innovation of the row before adds to each component in this row, and to their sum.
  Eigen::MatrixXd update_;
  Eigen::VectorXd update_of_sum_;
  Eigen::VectorXd scale_;  // 1 / standard deviation of each innovation
};

}  // namespace fogcomp::noise
