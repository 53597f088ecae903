#pragma once

#include <Eigen/Core>
#include <vector>

#include "judge/mode_bands.hpp"
#include "judge/prediction.hpp"
#include "series/signal_series.hpp"

namespace fogcomp::planning {

/// Inner products over rows in which each counts by what the noise leaves of it.
class WeightedRows {
 public:
  WeightedRows(const std::vector<recording::RowRange>& stretches, double row_s,
               const judge::NoiseLevels& noise);

  /// left^T W right, W the inverse of the noise's covariance, (deg/h)^-2.
  Eigen::MatrixXd products(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right) const;

 private:
  judge::ModeBands bands_;
  Eigen::VectorXd weights_;  // of each band: inverse variance of a mode
};

/// The rows of a series with these columns, none of which has a prior.
judge::Rows rows_with(const series::SignalSeries& series, Eigen::MatrixXd columns);

}  // namespace fogcomp::planning
