#pragma once

#include <Eigen/Core>
#include <vector>

namespace fogcomp::fit {

/// What rows say of unknowns: ln likelihood = towards' x - x' information x / 2, x from the prior's
/// mean.
struct Seen {
  Eigen::MatrixXd information;
  Eigen::VectorXd towards;
};

/// Standard deviation of each unknown, relative to the prior's, that makes the rows most probable.
///
/// An unknown may be unlike what is known beforehand: a part was repaired. Then it has a departure
/// of its own, of any size: one beyond x standard deviations is as probable as 1/x. This has no
/// scale and no largest value. So a prior is Gaussian within 1.4 standard deviations and lets go of
/// what is farther off, if the rows show that it is.
Eigen::VectorXd widening(const Eigen::MatrixXd& covariance, const Seen& seen);

/// With these standard deviations, relative to the covariance's; correlations are with what does
/// not depart.
Eigen::MatrixXd with_departures(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& widening);

/// What the rows change of one unknown.
struct Departure {
  double change = 0;  ///< of the mean
  double sigmas = 0;  ///< in standard deviations of such a change, of noise and prior
  double gain = 0;  ///< ln of the ratio of probabilities of the rows, with a departure and without

  /// The rows show it (judge::kGain).
  bool is_certain() const;
};
/// Of each unknown, the others as wide as `widening` has them.
std::vector<Departure> departures(const Eigen::MatrixXd& covariance, const Seen& seen,
                                  const Eigen::VectorXd& widening);

}  // namespace fogcomp::fit
