#pragma once

#include "fit/noise_weighted_fit.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// Largest uncertainty of a model's drift in a soak at any temperature of its trained range.
struct SoakUncertainty {
  double sigma_dph = 0;  ///< one standard deviation
  double at_degc = 0;
};

/// `at_power_on`: where a board begins, whenever the recordings began; else in the middle of their
/// time. `model`: with the terms and coefficients of `fit` and its trained range. A second
/// temperature follows the first; other inputs are at their means over `rows`. `covariance`: of
/// coefficients and shapes in the order of fit.covariance, correlations included.
SoakUncertainty soak_uncertainty(const model::Model& model, const NoiseWeightedFit& fit,
                                 const Eigen::MatrixXd& covariance, const series::Rows& rows,
                                 bool at_power_on);

}  // namespace fogcomp::fit
