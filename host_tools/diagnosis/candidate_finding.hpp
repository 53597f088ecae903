#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/evidence_space.hpp"
#include "recording/mask.hpp"

namespace fogcomp::diagnosis {

/// Result of a diagnosis for one effect of the catalogue, or for one offered expression.
struct CandidateFinding {
  std::string effect;
  /// The model with it: refitted terms with coefficients, this effect the last of them.
  std::vector<model::EffectTerm> completed;
  std::vector<model::EffectTerm> possible;  ///< its shapes that explain about as much as the best
  double explained_fraction = 0;            ///< of what the model leaves above the noise, 0..1
  double rms_after_dph = 0;                 ///< rms of a row, this effect added and all refitted
  double evidence = 0;                      ///< ln of the odds against "nothing is missing"
  double probability = 0;                   ///< that this effect is among those that are missing
  double lead = 0;                          ///< that it is the largest of them
  double visible_from_dph = 0;              ///< rms over the rows: these would have shown it
  std::optional<recording::Cut> cut{};      ///< of a bias step: where the bias would begin anew

  const model::EffectTerm& term() const { return completed.back(); }
  bool is_expression() const { return term().expression.has_value(); }
};

/// Findings for all candidates, in their order.
std::vector<CandidateFinding> find_of_candidates(const EvidenceSpace& evidence,
                                                 const judge::Explanations& explanations,
                                                 const series::SignalSeries& series,
                                                 const fit::NoiseWeightedFit& fit);

/// In the order in which all outputs list the findings: the one that is most probably the largest
/// effect first.
std::vector<CandidateFinding> sorted_by_lead(std::vector<CandidateFinding> findings);

}  // namespace fogcomp::diagnosis
