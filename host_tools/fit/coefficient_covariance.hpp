#pragma once

#include <Eigen/Core>

#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::fit {

/// Covariance of a fit's coefficients and shape parameters, in the units of fit.covariance: what
/// the noise of all rows does to them, and not only the noise that the rows were weighted with.
///
/// The rows are weighted with the noise of the quiet parts, which are too short for what slow noise
/// does over hours, and show none by chance. So the residual of all rows is asked as well: by
/// restricted likelihood of its cosine transform, which has nearly independent values for white
/// noise, the slow noise of the quiet parts, more flicker, a random walk of the bias, and what an
/// effect leaves that the model lacks (what the fit itself takes out of it is reckoned with); what
/// is noise must be likely in the quiet parts' spectrum too. Over all levels of these, weighted by
/// how likely they are, +-1.96 standard deviations hold 95 %. Empty where fit.covariance is.
Eigen::MatrixXd coefficient_covariance(const series::Rows& rows, const NoiseWeightedFit& fit);

}  // namespace fogcomp::fit
