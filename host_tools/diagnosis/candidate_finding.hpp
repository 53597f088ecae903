#pragma once

#include <string>
#include <vector>

#include "diagnosis/evidence_space.hpp"

namespace fogcomp::diagnosis {

/// What a diagnosis says of one effect of the catalogue, or of one expression offered.
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

  const model::EffectTerm& term() const { return completed.back(); }
  bool is_expression() const { return term().expression.has_value(); }
};

/// Of every candidate, the likeliest to be the largest first. `excess`: chi^2 above noise that
/// there is to explain.
std::vector<CandidateFinding> find_of_candidates(const EvidenceSpace& evidence,
                                                 const std::vector<Hypothesis>& hypotheses,
                                                 double excess, const series::SignalSeries& series,
                                                 const fit::NoiseWeightedFit& fit);

/// Where no test finds anything beside noise: an effect is believed as far as its own evidence
/// goes, and as far as no random walk explains it.
void believe_less(std::vector<CandidateFinding>& findings, double chance_of_walk);

/// In the order in which findings are told everywhere.
void sort_by_lead(std::vector<CandidateFinding>& findings);

}  // namespace fogcomp::diagnosis
