#pragma once

#include "diagnosis/evidence_space.hpp"
#include "judge/explanations.hpp"

namespace fogcomp::diagnosis {

/// Probabilities of all explanations of what the model leaves: the candidates as effects, the
/// smooth structure but for that of time as something else. Takes the modes of the candidates and
/// the columns of the smooth structure but for VisibleStructure::all. `series`: that of the
/// evidence.
judge::Explanations explain(EvidenceSpace& evidence, const series::SignalSeries& series);

}  // namespace fogcomp::diagnosis
