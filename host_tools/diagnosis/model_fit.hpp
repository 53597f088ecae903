#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "diagnosis/diagnosis_data.hpp"
#include "fit/noise_weighted_fit.hpp"

namespace fogcomp::diagnosis {

/// First stage of a diagnosis: solves for the model's effects, without its network, and for each
/// run's own bias. The rows are whitened with `noise`, or else with the noise of their quiet parts.
/// Throws InputError for fewer than rules::kMinRows rows, or too few for the model.
fit::NoiseWeightedFit fit_for_diagnosis(const model::Model& model, const DiagnosisData& data,
                                        const std::optional<noise::NoiseModel>& noise);

/// Rms of a residual over the rows that count, deg/h.
double rms_of_rows(const series::Rows& rows, const fit::NoiseWeightedFit& fit,
                   const Eigen::VectorXd& residual);

/// The terms and, last, `added`, which replaces a smaller version of itself.
std::vector<model::EffectTerm> with_term(std::vector<model::EffectTerm> terms,
                                         const model::EffectTerm& added);

/// Terms with least-squares coefficients, and the residual of each row.
struct Refit {
  std::vector<model::EffectTerm> terms;
  Eigen::VectorXd residual_dph;
};

/// Solves for the coefficients of `terms`, with fixed shapes, and for each run's own bias, with the
/// row weights of `fit` of the same `series`.
Refit refit(std::vector<model::EffectTerm> terms, const series::SignalSeries& series,
            const fit::NoiseWeightedFit& fit);

}  // namespace fogcomp::diagnosis
