#include "diagnosis/walk_finding.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/null_test.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

// Effects, and smooth structure of any kind. Prior: an effect of the basis is as probable as none,
// and so is structure.
std::vector<fit::Explanatory> explanatory(const fit::ExplainedSpace& space,
                                          const std::vector<Hypothesis>& hypotheses,
                                          const EvidenceSpace& evidence) {
  const double each = -std::log(static_cast<double>(evidence.regressors.size()));
  std::vector<fit::Explanatory> all;
  for (const Hypothesis& h : hypotheses) all.push_back({h.log_evidence, h.log_prior + each});
  all.push_back({fit::log_evidence(space.chi2_drop({evidence.structure}),
                                   static_cast<double>(evidence.structure.count)),
                 0});
  return all;
}

bool is_of_time(const Hypothesis& hypothesis, const EvidenceSpace& evidence) {
  return std::any_of(hypothesis.parts.begin(), hypothesis.parts.end(),
                     [&](const Hypothesis::Part& part) {
                       return evidence.candidates[part.candidate].is_of_time();
                     });
}

}  // namespace

std::string WalkFinding::words() const {
  constexpr double kAsWell = 0.1;
  return format("a random walk of the bias of %.2g deg/h/sqrt(h) ", coefficient) +
         (chance > kAsWell
              ? "explains them as well as any effect"
              : format("beside the noise has a probability of %.2g, too much to name an effect",
                       chance)) +
         (has_static ? ": one more run of the programme would tell"
                     : ": one more run of the programme, or a recording at rest with --static, "
                       "would tell");
}

WalkFinding assess_walk(const EvidenceSpace& evidence, const std::vector<Hypothesis>& hypotheses,
                        const noise::NoiseModel& noise, std::uint64_t seed) {
  if (!noise.from_quiet_parts) return {};
  const fit::WalkRival rival = fit::find_walk(evidence.space, evidence.walk, noise.walks);
  if (rival.coefficient == 0) return {};
  const std::vector<Hypothesis> beside =
      find_hypotheses(rival.space, evidence.candidates, evidence.regressors);
  WalkFinding finding{rival.coefficient,
                      fit::chance_of_walk(rival, explanatory(evidence.space, hypotheses, evidence),
                                          explanatory(rival.space, beside, evidence)),
                      1, !hypotheses.empty() && is_of_time(hypotheses.front(), evidence)};
  if (!finding.may_be_all()) return finding;
  const NullTest test = test_against_noise(rival.space, evidence.regressors, evidence.structure,
                                           noise.degrees_of_freedom, seed);
  finding.noise_alone = std::exp(std::min(test.library_log_p, test.structure_log_p));
  return finding;
}

}  // namespace fogcomp::diagnosis
