#pragma once

#include <Eigen/Core>
#include <vector>

#include "noise/allan.hpp"

namespace fogcomp::noise {

/// What the noise terms of IEEE Std 952 predict for the points of one Allan deviation: their values
/// and how they scatter together. Times are in hours, so that the coefficients come out in the
/// units of the standard; `squares` are coefficients squared, 0 for a term that is not there.
class AllanModel {
 public:
  enum Term : Eigen::Index { kQuantization, kAngleWalk, kInstability, kRateWalk, kRamp };
  static constexpr Eigen::Index kTerms = 5;

  explicit AllanModel(const std::vector<AllanPoint>& points);

  /// sigma^2 of each point (row) for each term alone (column) with a square of 1.
  const Eigen::MatrixXd& terms() const { return terms_; }

  /// Covariance of the points' sigma^2. Overlapping averages of different length share data, so
  /// neighbouring octaves go together: by 0.53 for white noise, 0.89 for a random walk.
  Eigen::MatrixXd covariance(const Eigen::VectorXd& squares) const;

 private:
  Eigen::MatrixXd covariance_of_noise(const Eigen::VectorXd& squares) const;
  Eigen::MatrixXd covariance_of_ramp(const Eigen::VectorXd& squares) const;

  Eigen::VectorXd tau_h_;
  Eigen::VectorXd span_h_;   // of data behind each point: pairs * tau
  Eigen::VectorXd range_h_;  // mean length of the ranges behind it
  Eigen::VectorXd ranges_;   // their number
  Eigen::MatrixXd terms_;
  Eigen::MatrixXd density_;   // row: frequency; column: random term; for a square of 1
  Eigen::MatrixXd response_;  // row: frequency; column: point; from density to sigma^2, times the
                              // root of the row's bandwidth
};

}  // namespace fogcomp::noise
