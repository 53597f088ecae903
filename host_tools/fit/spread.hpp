#pragma once

#include <Eigen/Core>
#include <vector>

#include "fit/departure.hpp"

namespace fogcomp::fit {

/// How unknowns are distributed over the gyros of a lot.
struct Spread {
  Eigen::VectorXd mean;
  Eigen::MatrixXd mean_covariance;  ///< of the mean
  Eigen::MatrixXd covariance;       ///< from gyro to gyro, what the rows do not know taken off
  Eigen::VectorXd variance_sigma;   ///< standard deviation of each of its variances

  /// Of a further gyro: the lot's, and how well mean and variances are known.
  Eigen::MatrixXd of_next_gyro() const;
};

/// Mean and covariance by expectation and maximisation (Dempster, Laird & Rubin 1977), from what
/// the rows of each gyro say: an unknown of which they say nothing counts for nothing. One that
/// certainly departs from the lot moves neither (departure.hpp). Of few gyros, correlations are
/// shrunk. At least two gyros; the mean counts from where `Seen` does.
Spread spread_of(const std::vector<Seen>& gyros);

/// Median and spread, robust, of values with these standard deviations; the spread is at least
/// their median. For a start.
struct RobustSpread {
  Eigen::VectorXd median;
  Eigen::VectorXd sigma;
};
RobustSpread robust_spread(const std::vector<Eigen::VectorXd>& values,
                           const std::vector<Eigen::VectorXd>& sigmas);

}  // namespace fogcomp::fit
