#pragma once

#include <functional>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/structure.hpp"
#include "judge/explanations.hpp"

namespace fogcomp::diagnosis {

/// Second stage of a diagnosis: all possible explanations of the residual. explain() takes what is
/// most of a diagnosis' memory.
struct EvidenceSpace {
  Residualizer residualizer;
  judge::ModeSpace modes;  ///< of the rows, and of what is not exact in the model's own terms
  std::vector<Candidate> candidates;
  std::vector<Untestable> untestable;
  VisibleStructure smooth;  ///< smooth functions of everything: no physics

  /// Whitened residual of the model.
  const Eigen::VectorXd& residual() const { return residualizer.residual(); }
  /// The effect of a candidate that is in `parts`: with the shape of its part or, where it is there
  /// twice, with both, the smaller first.
  model::EffectTerm term_in(const std::vector<judge::Part>& parts, std::size_t candidate) const;
};

/// `fit`: of the rows of `data`; both must outlive the result. The noise is that of the fit if it
/// `is_noise_known`, otherwise these rows tell. `progress` is called with the fraction done, 0..1.
/// Throws InputError like find_candidates().
EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  bool is_noise_known, const std::function<void(double)>& progress);

/// Whitened residual less the parts explained by a set of effects and by smooth functions.
/// `series`: that of the evidence.
Eigen::VectorXd without(const EvidenceSpace& evidence, const std::vector<judge::Part>& parts,
                        const series::SignalSeries& series);

}  // namespace fogcomp::diagnosis
