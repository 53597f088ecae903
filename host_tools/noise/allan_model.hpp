#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/allan.hpp"

namespace fogcomp::noise {

/// Expectation of the points of one Allan deviation for the noise terms of IEEE Std 952: values and
/// covariance. Times are in hours, so that the coefficients have the units of the standard;
/// `squares` are squared coefficients, 0 for an absent term.
class AllanModel {
 public:
  enum Term : Eigen::Index { kQuantization, kAngleWalk, kInstability, kRateWalk, kRamp };
  static constexpr Eigen::Index kTerms = 5;

  explicit AllanModel(const std::vector<AllanPoint>& points);

  /// sigma^2 at an averaging time of each term alone with squared coefficient 1.
  static Eigen::RowVectorXd variance_of_terms(double tau_h);

  /// sigma^2 of each point (row) for each term alone (column) with squared coefficient 1.
  const Eigen::MatrixXd& terms() const { return terms_; }

  /// Covariance of the points' sigma^2. Overlapping averages of different length share data, so
  /// neighbouring octaves are correlated: by 0.53 for white noise, 0.89 for a random walk.
  Eigen::MatrixXd covariance(const Eigen::VectorXd& squares) const;

 private:
  Eigen::MatrixXd covariance_of_noise(const Eigen::VectorXd& squares) const;
  Eigen::MatrixXd covariance_of_ramp(const Eigen::VectorXd& squares) const;

  Eigen::VectorXd tau_h_;
  Eigen::VectorXd span_h_;   // duration of data per point: pairs * tau
  Eigen::VectorXd range_h_;  // mean length of its ranges
  Eigen::VectorXd ranges_;   // number of its ranges
  Eigen::MatrixXd terms_;
  Eigen::MatrixXd density_;   // row: frequency; column: random term, for squared coefficient 1
  Eigen::MatrixXd response_;  // row: frequency; column: point; from density to sigma^2, times
                              // root of the row's bandwidth
};

}  // namespace fogcomp::noise
