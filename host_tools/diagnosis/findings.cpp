// What is asked of a diagnosis that is made.
#include <algorithm>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/diagnosis.hpp"

namespace fogcomp {

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::none:
      return "none";
    case Verdict::missing_effect:
      return "missing_effect";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::unknown:
      break;
  }
  return "unknown";
}

const CandidateFinding* Diagnosis::find(const std::string& name) const {
  const auto found =
      std::find_if(candidates.begin(), candidates.end(),
                   [&](const CandidateFinding& finding) { return finding.effect == name; });
  return found == candidates.end() ? nullptr : &*found;
}

std::vector<std::string> effects_together(const Diagnosis& diagnosis) {
  if (diagnosis.verdict != Verdict::missing_effect) return {};
  if (diagnosis.find(diagnosis.effect)->rms_after_dph < diagnosis.residual_rms_dph) return {};
  for (const Diagnosis::Explanation& set : diagnosis.explanations) {
    const bool has_it =
        std::find(set.effects.begin(), set.effects.end(), diagnosis.effect) != set.effects.end();
    if (has_it && set.effects.size() > 1) return set.effects;
  }
  return {};
}

std::string effect_to_add(const Diagnosis& diagnosis) {
  if (!effects_together(diagnosis).empty()) return "";
  if (diagnosis.verdict == Verdict::missing_effect) return diagnosis.effect;
  if (diagnosis.verdict == Verdict::ambiguous) {
    const CandidateFinding* best = diagnosis.find(diagnosis.confusable.front());
    const double alike = rules::kNearlyAsLikely * best->lead;
    for (const std::string& effect : diagnosis.confusable) {
      const CandidateFinding* other = diagnosis.find(effect);
      const bool leaves_less = other->rms_after_dph < rules::kClearlyLess * best->rms_after_dph;
      if (other->lead >= alike && leaves_less) best = other;
    }
    return best->effect;
  }
  const bool walk = diagnosis.walk.may_be_all();
  if (diagnosis.verdict == Verdict::unknown && !walk && !diagnosis.candidates.empty()) {
    const auto most =
        std::max_element(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                         [](const auto& a, const auto& b) { return a.evidence < b.evidence; });
    const bool main = most->probability >= rules::kNamed &&
                      most->explained_fraction >= rules::kMainPart &&
                      most->rms_after_dph < diagnosis.residual_rms_dph;
    if (main) return most->effect;
  }
  return "";
}

}  // namespace fogcomp
