#include "diagnosis/candidate_finding.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/model_fit.hpp"
#include "support/evidence.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

CandidateFinding find_of(std::size_t candidate, const EvidenceSpace& evidence,
                         const judge::Explanations& explanations,
                         const series::SignalSeries& series, const fit::NoiseWeightedFit& fit) {
  const Candidate& own = evidence.candidates[candidate];
  const judge::Explanations::Effect& effect = explanations.effects[candidate];
  CandidateFinding finding;
  finding.effect = own.effect;
  finding.probability = effect.probability;
  finding.lead = effect.largest;
  finding.evidence = effect.log_odds;
  finding.explained_fraction = effect.explained;
  finding.visible_from_dph = effect.visible_from_dph;
  const double best = *std::max_element(effect.log_likelihood.begin(), effect.log_likelihood.end());
  for (std::size_t s = 0; s < own.shapes.size(); ++s) {
    if (effect.log_likelihood[s] < best - kPossibleSigmas * kPossibleSigmas / 2 &&
        s != effect.shape)
      continue;
    finding.possible.push_back(own.shapes[s].term);
  }
  const auto likeliest =
      std::find_if(explanations.all.begin(), explanations.all.end(),
                   [&](const judge::Explanation& one) { return one.has(candidate); });
  const model::EffectTerm added = likeliest == explanations.all.end()
                                      ? own.shapes[effect.shape].term
                                      : evidence.term_in(likeliest->parts, candidate);
  Refit completed = refit(with_term(fit.terms, added), series, fit);
  finding.rms_after_dph = rms_of_rows(series.rows(), fit, completed.residual_dph);
  finding.completed = std::move(completed.terms);
  return finding;
}

}  // namespace

std::vector<CandidateFinding> find_of_candidates(const EvidenceSpace& evidence,
                                                 const judge::Explanations& explanations,
                                                 const series::SignalSeries& series,
                                                 const fit::NoiseWeightedFit& fit) {
  std::vector<CandidateFinding> findings(evidence.candidates.size());
  for_each_index(findings.size(), [&](std::size_t i) {
    findings[i] = find_of(i, evidence, explanations, series, fit);
  });
  return findings;
}

// Order by probability of being the largest; differences by rounding count as equal, and then
// effects of the catalogue come before expressions.
std::vector<CandidateFinding> sorted_by_lead(std::vector<CandidateFinding> findings) {
  const auto rank = [](const CandidateFinding& finding) {
    const auto rounded = [](double value, double unit) { return std::round(value / unit); };
    return std::make_tuple(rounded(finding.lead, 1e-6), rounded(finding.probability, 1e-6),
                           rounded(finding.evidence, 1e-3));
  };
  std::stable_sort(
      findings.begin(), findings.end(),
      [&](const CandidateFinding& a, const CandidateFinding& b) { return rank(a) > rank(b); });
  return findings;
}

}  // namespace fogcomp::diagnosis
