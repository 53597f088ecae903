#pragma once

#include <optional>

#include "diagnosis/diagnosis_data.hpp"
#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::diagnosis {

/// First stage of a diagnosis: the model's effects, its network left out, solved for anew together
/// with each run's own bias, the rows whitened with `noise` or else with the noise of their quiet
/// parts. Throws InputError for fewer rows than any opinion needs, and for too few for the model.
fit::NoiseWeightedFit fit_for_diagnosis(const model::Model& model, const DiagnosisData& data,
                                        const std::optional<noise::NoiseModel>& noise);

/// Rms of a residual over the rows that count, deg/h.
double rms_of_rows(const series::Rows& rows, const fit::NoiseWeightedFit& fit,
                   const Eigen::VectorXd& residual);

/// Whether these are recordings at rest themselves.
bool at_rest(const series::Rows& rows);

}  // namespace fogcomp::diagnosis
