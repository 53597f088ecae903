#pragma once

#include <functional>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/structure.hpp"
#include "diagnosis/visible_part.hpp"
#include "judge/explanations.hpp"

namespace fogcomp::diagnosis {

/// Second stage of a diagnosis: columns of all possible explanations of the residual, as they are,
/// and whitened with the model projected out. explain() takes most of them, which are most of a
/// diagnosis' memory, so that they do not lie beside the judge's.
struct EvidenceSpace {
  Residualizer residualizer;
  std::vector<Candidate> candidates;
  std::vector<Untestable> untestable;
  VisibleStructure smooth;  ///< smooth functions of everything: no physics

  /// Whitened residual of the model.
  const Eigen::VectorXd& residual() const { return residualizer.residual(); }
  /// The effect of a candidate that is in `parts`: with the shape of its part or, where it is there
  /// twice, with both, the smaller first.
  model::EffectTerm term_in(const std::vector<judge::Part>& parts, std::size_t candidate) const;
};

/// `fit`: of the rows of `data`; both must outlive the result. `progress` is called with the
/// fraction done, 0..1. Throws InputError like find_candidates().
EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress);

/// Whitened residual less the parts explained by a set of effects and by smooth functions.
/// `series`: that of the evidence.
Eigen::VectorXd without(const EvidenceSpace& evidence, const std::vector<judge::Part>& parts,
                        const series::SignalSeries& series);

}  // namespace fogcomp::diagnosis
