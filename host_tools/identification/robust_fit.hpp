#pragma once

#include <Eigen/Core>
#include <vector>

#include "identification/least_squares.hpp"
#include "identification/noise_model.hpp"
#include "identification/shape_search.hpp"
#include "identification/signal_series.hpp"
#include "model/model.hpp"

namespace fogcomp {

/// Effects fitted to rows: coefficients and shapes, the noise that they leave, and what the rows
/// were weighted with.
struct RobustFit {
  std::vector<EffectTerm> terms;       ///< with their shapes identified; coefficients as given
  std::vector<ShapeParameter> shapes;  ///< which of their parameters were
  Eigen::MatrixXd matrix;        ///< rows x regressors of all terms, then the nuisance columns
  LinearFit fit;                 ///< whitened: coefficients and covariance of `matrix`'
                                 ///< columns, then of the shapes' places in their ranges
  Eigen::VectorXd residual_dph;  ///< per row
  NoiseModel noise;
  Eigen::VectorXd robust;  ///< weights against outliers: 1 for all others, 0 for rows left out

  Eigen::Index linear() const { return matrix.cols(); }
  /// rms of the whitened residual, at least 1: by how much standard deviations are widened.
  double misfit() const;
};

/// Three rounds of noise, outlier weights and solution, as identify() says. `nuisance`: further
/// columns, rows x any. `kept`: 1 per row, 0 for rows that count for nothing. Throws InputError for
/// too few rows, and for columns that the rows cannot tell apart.
RobustFit fit_robustly(const SignalSeries& series, const std::vector<EffectTerm>& terms,
                       const Eigen::MatrixXd& nuisance, const Eigen::VectorXd& kept);

}  // namespace fogcomp
