#pragma once

#include <Eigen/Core>
#include <vector>

#include "recording/row_range.hpp"

namespace fogcomp::judge {

/// Errors of the temperature from which a model's columns are computed: what is left of the
/// thermometer's noise and resolution after smoothing.
struct TemperatureError {
  double white_degc2_s = 0;           ///< spectral density of the thermometer's noise
  double rate_walk_degc2_per_s3 = 0;  ///< of the temperature rate's changes; 0: no errors
  double slope_dph_per_degc = 0;      ///< rms of the drift's derivative by the temperature
  double slope_dph_min_per_degc = 0;  ///< rms of its derivative by the temperature rate
};

/// Rows of one or more recordings, and what a model can do in them.
struct Rows {
  double row_s = 0;
  Eigen::VectorXd drift_dph;  ///< measured
  Eigen::MatrixXd columns;    ///< rows x unknowns: derivatives of the model's drift
  /// Standard deviation of each unknown that is known beforehand; 0: nothing is.
  Eigen::VectorXd prior_sigma;
  /// Unknowns from this one on have their estimate already, as shapes that a search has found: they
  /// widen the covariance and change no other estimate.
  Eigen::Index first_found = 0;
  Eigen::VectorXd weights;  ///< inverse variance of a row's noise, relative; 0: excluded
  std::vector<recording::RowRange> stretches;  ///< evenly spaced rows, in order; all rows
  std::vector<recording::RowRange> power_ons;  ///< that have a bias of their own; empty: none
  TemperatureError temperature;
};

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
