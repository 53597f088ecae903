#pragma once

#include <cmath>

#include "fit/known_regressors.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "judge/prediction.hpp"
#include "series/term_columns.hpp"

namespace fogcomp::fit {

/// Standard deviation of a shape's position in its range, 0 to 1, of which nothing is known.
inline const double kSigmaOfPosition = std::sqrt(1.0 / 12);

/// What a model can do in rows.
struct PossibleDrift {
  const Eigen::MatrixXd& columns;      ///< derivatives of the drift by the model's unknowns
  const Eigen::VectorXd& prior_sigma;  ///< of each unknown; 0: nothing is known
  Eigen::Index first_found;            ///< as in judge::Rows
};
/// Levels of noise as Gauss-Markov components; white: of one of the rows.
noise::NoiseModel noise_model(const judge::NoiseLevels& levels, const series::Rows& rows);
/// Noise of rows beside that (white, flicker and a random walk, by judge::Prediction) as
/// Gauss-Markov components. `weights`: 0 for excluded rows.
noise::NoiseModel noise_beside(const PossibleDrift& possible, const series::Rows& rows,
                               const Eigen::VectorXd& drift_dph, const Eigen::VectorXd& weights);

/// The same beside the columns and shapes of a fit. Requires is_determined().
noise::NoiseModel noise_beside(const series::Rows& rows, const NoiseWeightedFit& fit);

/// What errors of the temperature make of a fit's drift. `fit`: of the gyro's own temperature.
judge::TemperatureError temperature_error(const KnownRegressors& known,
                                          const NoiseWeightedFit& fit);

/// Rows for judge, with the columns of a fit but for `without`, and with its shapes.
judge::Rows judged_rows(const series::Rows& rows, const NoiseWeightedFit& fit,
                        const series::ColumnRange& without);

/// Columns of which nobody asks, before the shapes, which are found already. `sigma`: of each
/// coefficient beforehand, 0: any.
void add_nuisances(const Eigen::MatrixXd& nuisances, double sigma, judge::Rows& judged);

/// A bias for each power-on. The model's bias is the one that it ends with: what is before a cut
/// has any, as a nuisance.
void add_biases(const series::Rows& rows, judge::Rows& judged);

/// What the rows of a fit say of its coefficients and, after them, of the positions of its shapes
/// in their ranges (0 to 1; any is equally probable beforehand): in the noise of all rows, white,
/// flicker and random walk, not only in that of the weights, and what its prior does. `reading`: of
/// the fit. Requires is_determined().
judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit,
                          series::Reading reading = series::Reading::of_sensor);

/// The same of the gyro's reading with a bias for each power-on, whose spread is found, instead of
/// the columns `offsets`, with inexact_rate_terms() and errors of the temperature.
judge::Prediction predict(const series::Rows& rows, const NoiseWeightedFit& fit,
                          const series::ColumnRange& offsets,
                          const judge::TemperatureError& temperature);

}  // namespace fogcomp::fit
