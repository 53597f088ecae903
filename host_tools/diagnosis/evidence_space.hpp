#pragma once

#include <functional>
#include <vector>

#include "diagnosis/candidates.hpp"
#include "diagnosis/diagnosis_data.hpp"
#include "diagnosis/hypotheses.hpp"
#include "diagnosis/structure.hpp"
#include "diagnosis/visible_part.hpp"
#include "fit/explained_space.hpp"
#include "fit/walk_rival.hpp"

namespace fogcomp::diagnosis {

/// Second stage of a diagnosis: all that might explain what a model leaves, as columns that are
/// whitened and free of what the model can do itself, and their inner products.
struct EvidenceSpace {
  Residualizer residualizer;
  std::vector<Candidate> candidates;
  std::vector<Untestable> untestable;
  VisibleStructure smooth;  ///< smooth functions of everything: no physics
  fit::ExplainedSpace space;
  // Where they lie in `space`:
  RegressorBasis regressors;  ///< the shapes of each candidate
  series::ColumnRange structure;
  fit::WalkModes walk;  ///< of a random walk of the bias

  /// What the model leaves of the measurement, whitened.
  const Eigen::VectorXd& residual() const { return residualizer.residual(); }
};

/// `fit`: of the rows of `data`; both must outlive the result. `progress` is told how much is done,
/// 0..1. Throws InputError as find_candidates().
EvidenceSpace make_evidence_space(const DiagnosisData& data, const fit::NoiseWeightedFit& fit,
                                  const std::function<void(double)>& progress);

/// The whitened residual without what a hypothesis and smooth functions explain of it, a value a
/// row.
Eigen::VectorXd without(const EvidenceSpace& evidence, const Hypothesis& hypothesis,
                        Eigen::Index rows);

}  // namespace fogcomp::diagnosis
