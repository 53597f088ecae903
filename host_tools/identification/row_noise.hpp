#pragma once

#include <Eigen/Core>

#include "identification/signal_series.hpp"

namespace fogcomp {

/// The noise of single rows, from how far each lies from the median of itself and its neighbours
/// (three on either side, across no gap): what drifts beneath, however far, does not enter.
struct RowNoise {
  /// Standard deviation of each row's noise relative to the typical row's (1). It is taken in
  /// windows of 128 rows; as far as these differ by no more than chance, all are 1.
  Eigen::VectorXd scale;
  /// 1 for each row that counts, 0 for one that stands out of its neighbours by more than 4.4 of
  /// its standard deviations, and for one that `kept` leaves out. Of 100,000 rows of normal noise
  /// four stand out.
  Eigen::VectorXd counted;
};

/// `residual`: per row, deg/h. `kept`: 1 per row, 0 for rows that are left out. The first and the
/// last row of a recording have neighbours on one side only and always count.
RowNoise row_noise(const Rows& rows, const Eigen::VectorXd& residual, const Eigen::VectorXd& kept);
RowNoise row_noise(const Rows& rows, const Eigen::VectorXd& residual);

/// A row that does not count has the value of the nearest row before it that does.
Eigen::VectorXd bridged(const Eigen::VectorXd& residual, const Eigen::VectorXd& counted);

}  // namespace fogcomp
