#pragma once

#include "diagnosis/evidence_space.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "judge/explanations.hpp"

namespace fogcomp::diagnosis {

/// Probabilities of all explanations of what the model of `fit` leaves: the candidates as effects,
/// the smooth structure but for that of time as something else, and what is not exact in the
/// model's own terms as nuisances. The noise is that of the fit if it `is_noise_known`, otherwise
/// these rows tell. Takes the columns of the candidates and of the smooth structure but for
/// VisibleStructure::all.
judge::Explanations explain(EvidenceSpace& evidence, const series::SignalSeries& series,
                            const fit::NoiseWeightedFit& fit, bool is_noise_known);

}  // namespace fogcomp::diagnosis
