#pragma once

#include <Eigen/Core>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::fit {

/// Covariance of a fit's coefficients and shape parameters, in the units of fit.covariance. It
/// covers the noise of all rows, not only the noise that the rows were weighted with.
///
/// The row weights come from the quiet parts, which are too short to show slow noise of hours. So
/// the residual of all rows is used as well, by restricted likelihood of its cosine transform,
/// whose values are nearly independent for white noise, slow noise of the quiet parts, additional
/// flicker, a random walk of the bias, and the remainder of a missing effect (less what the fit
/// absorbs of it). The noise must also be probable in the spectrum of the quiet parts. Averaged
/// over all levels by their probability, +-1.96 standard deviations contain 95 %. Empty if
/// fit.covariance is empty.
Eigen::MatrixXd coefficient_covariance(const series::Rows& rows, const NoiseWeightedFit& fit);

}  // namespace fogcomp::fit
