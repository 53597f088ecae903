// What is asked of a diagnosis that is made.
#include <algorithm>

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

std::string effect_to_add(const Diagnosis& diagnosis) {
  constexpr double kClearly = 0.97;  // of the rms
  constexpr double kMainPart = 0.5;
  if (diagnosis.verdict == Verdict::missing_effect) return diagnosis.effect;
  if (diagnosis.verdict == Verdict::ambiguous) {
    std::string best = diagnosis.confusable.front();
    for (const std::string& effect : diagnosis.confusable) {
      const double rms = diagnosis.find(effect)->rms_after_dph;
      if (rms < kClearly * diagnosis.find(best)->rms_after_dph) best = effect;
    }
    return best;
  }
  if (diagnosis.verdict == Verdict::unknown && !diagnosis.candidates.empty()) {
    const auto most =
        std::max_element(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                         [](const auto& a, const auto& b) { return a.evidence < b.evidence; });
    const bool main = most->probability >= kNamed && most->explained_fraction >= kMainPart;
    if (main) return most->effect;
  }
  return "";
}

}  // namespace fogcomp
