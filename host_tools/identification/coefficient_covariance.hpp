#pragma once

#include <Eigen/Core>

#include "identification/noise_weighted_fit.hpp"

namespace fogcomp {

/// Covariance of a fit's coefficients and shape parameters, in the units of fit.covariance: what
/// the noise of all rows does to them, and not only the noise that the rows were weighted with.
///
/// That noise comes from the quiet parts, which are too short for what slow noise does over hours,
/// and show none by chance. So what the fit leaves of all rows is asked again: white noise, the
/// slow noise of the quiet parts, flicker and a random walk of the bias, by restricted likelihood
/// of the residual's cosine transform (which has nearly independent values for each of them; what
/// the fit itself takes out of them is reckoned with), and the covariance is averaged over their
/// levels by how likely they are. An effect that the model lacks counts as slow noise. Empty where
/// fit.covariance is.
Eigen::MatrixXd coefficient_covariance(const Rows& rows, const NoiseWeightedFit& fit);

}  // namespace fogcomp
