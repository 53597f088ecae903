#pragma once

#include <Eigen/Core>

#include "judge/rows.hpp"

namespace fogcomp::judge {

/// Noise of a gyro by IEEE Std 952.
struct NoiseLevels {
  double white_dph = 0;    ///< of a row: angle random walk
  double flicker_dph = 0;  ///< bias instability: coefficient B, the Allan deviation's floor / 0.664
  double walk_dph_per_rth = 0;  ///< rate random walk
  double turn_on_dph = 0;       ///< standard deviation of the bias from power-on to power-on
};

/// What rows say of a model's unknowns: mean and covariance. One linear Gaussian problem with white
/// noise, flicker, a random walk of the bias, and biases of power-ons, whose variances are found in
/// the same rows by restricted likelihood (Patterson & Thompson 1971) and integrated over.
///
/// Every stretch goes through a cosine transform, in which the noises are variances per mode
///   S(f) = white + flicker / f + walk / f^2,   f: angle per row,
/// so that no soak and no quiet row is needed: an effect has its own shape over the modes, and what
/// it cannot explain is noise. A bias of a power-on is a column with a variance of its own.
class Prediction {
 public:
  explicit Prediction(const Rows& rows);
  /// The same of other unknowns: origin + slopes * these.
  Prediction of(const Eigen::VectorXd& origin, const Eigen::MatrixXd& slopes) const;

  const Eigen::VectorXd& mean() const { return mean_; }
  /// NaN if the rows do not determine an unknown without a prior.
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  const NoiseLevels& noise() const { return noise_; }
  /// Bias of each power-on less the model's, and their covariance.
  const Eigen::VectorXd& turn_on_biases() const { return turn_on_biases_; }

 private:
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  NoiseLevels noise_;
  Eigen::VectorXd turn_on_biases_;
};

}  // namespace fogcomp::judge
