#include "diagnosis/candidate_finding.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/model_fit.hpp"
#include "diagnosis/refit.hpp"
#include "fit/decision_rules.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

// Sets the candidate's probability among the hypotheses. Returns the most probable hypothesis that
// contains it, if one does.
const Hypothesis* set_probability(std::size_t candidate, const EvidenceSpace& evidence,
                                  const std::vector<Hypothesis>& hypotheses,
                                  CandidateFinding& finding) {
  const Hypothesis* likeliest = nullptr;
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!hypothesis.has(candidate)) continue;
    finding.probability += hypothesis.probability;
    if (leading_candidate(evidence.space, evidence.regressors, hypothesis) == candidate) {
      finding.lead += hypothesis.probability;
    }
    if (likeliest == nullptr) likeliest = &hypothesis;
  }
  return likeliest;
}

CandidateFinding find_of(std::size_t candidate, const EvidenceSpace& evidence,
                         const std::vector<Hypothesis>& hypotheses, double excess,
                         const series::SignalSeries& series, const fit::NoiseWeightedFit& fit) {
  const Candidate& own = evidence.candidates[candidate];
  const std::vector<series::ColumnRange>& ranges = evidence.regressors[candidate];
  const BestShape best = best_shape(evidence.space, ranges, {}, evidence.space.projection());
  CandidateFinding finding;
  finding.effect = own.effect;
  const Hypothesis* const likeliest = set_probability(candidate, evidence, hypotheses, finding);
  const std::size_t shape = likeliest == nullptr ? best.shape : likeliest->shape_of(candidate);
  finding.evidence = best.log_evidence;
  if (excess > 0) {
    const auto columns = static_cast<double>(ranges[shape].count);
    finding.explained_fraction = std::clamp((best.chi2_drop - columns) / excess, 0.0, 1.0);
  }
  const double all_but =
      best.chi2_drop - rules::kPossible * (1 + fit::rules::kModelFormTolerance * best.chi2_drop);
  for (std::size_t s = 0; s < ranges.size(); ++s) {
    if (s != shape && evidence.space.chi2_drop({ranges[s]}) < all_but) continue;
    finding.possible.push_back(own.shapes[s].term);
  }
  std::vector<model::EffectTerm> terms = fit.terms;
  put(terms, likeliest == nullptr ? own.shapes[shape].term
                                  : term_in(*likeliest, candidate, evidence.candidates));
  Refit completed = refit(std::move(terms), series, fit);
  finding.rms_after_dph = rms_of_rows(series.rows(), fit, completed.residual_dph);
  finding.completed = std::move(completed.terms);
  return finding;
}

}  // namespace

std::vector<CandidateFinding> find_of_candidates(const EvidenceSpace& evidence,
                                                 const std::vector<Hypothesis>& hypotheses,
                                                 double excess, const series::SignalSeries& series,
                                                 const fit::NoiseWeightedFit& fit) {
  std::vector<CandidateFinding> findings(evidence.candidates.size());
  for_each_index(findings.size(), [&](std::size_t i) {
    findings[i] = find_of(i, evidence, hypotheses, excess, series, fit);
  });
  return findings;
}

void limit_to_own_evidence(std::vector<CandidateFinding>& findings, double chance_of_walk) {
  for (CandidateFinding& finding : findings) {
    const double believed =
        std::min(1.0, std::exp(finding.evidence) / rules::kBelievedOdds) * (1 - chance_of_walk);
    finding.probability *= believed;
    finding.lead *= believed;
  }
}

// Order by probability of being the largest; differences by rounding count as equal, and then
// effects of the catalogue come before expressions.
void sort_by_lead(std::vector<CandidateFinding>& findings) {
  const auto rank = [](const CandidateFinding& finding) {
    const auto rounded = [](double value) { return std::round(1e9 * value); };
    return std::make_tuple(rounded(finding.lead), rounded(finding.probability),
                           rounded(finding.evidence));
  };
  std::stable_sort(
      findings.begin(), findings.end(),
      [&](const CandidateFinding& a, const CandidateFinding& b) { return rank(a) > rank(b); });
}

}  // namespace fogcomp::diagnosis
