#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "judge/mode_bands.hpp"
#include "noise/noise_model.hpp"
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
  /// Known from another recording, for explain(); otherwise these rows tell.
  std::optional<noise::NoiseModel> noise;

  Eigen::Index size() const { return drift_dph.size(); }
};

/// Values of rows (rows x any number) relative to the noise of each; those that do not count are
/// interpolated, so that a model stays exact.
Eigen::MatrixXd bridged(const Rows& rows, Eigen::MatrixXd values);

/// 1 in the rows of each power-on, else 0.
Eigen::MatrixXd power_on_columns(const Rows& rows);

/// Variance per mode of what the temperature's errors make of the drift, (deg/h)^2, in each band.
Eigen::ArrayXd density_of_temperature(const Rows& rows, const ModeBands& bands);
/// ln of the density, but for a constant, of the temperature's errors being `factor` times as large
/// as expected: how a temperature bends within its thermometer's steps is not known better.
double log_prior_of_temperature(double factor);

/// Rows, and what turns columns of them into the cosine modes in which a judge compares them.
class ModeSpace {
 public:
  explicit ModeSpace(Rows rows);

  const Rows& rows() const { return rows_; }
  const ModeBands& bands() const { return bands_; }

  /// Modes of an effect's columns (rows x any number), each of which has an rms of 1 about its
  /// mean: only as many as columns have that are as smooth as drift (ModeBands::needed()).
  Eigen::MatrixXd of_effect(const Eigen::MatrixXd& columns) const;

 private:
  Rows rows_;
  ModeBands bands_;
};

/// Root of the mean square of a column about its mean.
double rms_about_mean(const Eigen::VectorXd& column);

}  // namespace fogcomp::judge
