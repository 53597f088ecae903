#pragma once

#include "fit/noise_weighted_fit.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// Where the drift of a model is known worst, among soaks at all temperatures of its trained range.
struct SoakUncertainty {
  double sigma_dph = 0;  ///< one standard deviation
  double at_degc = 0;
};

/// `model`: with the terms and coefficients of `fit` and its trained range. Inputs beside the
/// temperature are at their means over `rows`. `covariance`: of coefficients and shapes in the
/// order of fit.covariance; what they share is counted.
SoakUncertainty soak_uncertainty(const model::Model& model, const NoiseWeightedFit& fit,
                                 const Eigen::MatrixXd& covariance, const series::Rows& rows);

}  // namespace fogcomp::fit
