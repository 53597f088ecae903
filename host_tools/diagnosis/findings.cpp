// Questions to a finished diagnosis.
#include <algorithm>
#include <numeric>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/diagnosis.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {

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

bool is_mainly_fast(const Diagnosis& diagnosis) {
  return diagnosis.fast_share >= kMost;
}

Diagnosis shown_by_formulas(Diagnosis diagnosis, double nothing) {
  diagnosis.verdict = Verdict::unknown;
  diagnosis.only_by_formula = true;
  diagnosis.nothing = nothing;
  diagnosis.blind_spot.clear();
  return diagnosis;
}

Diagnosis without_name(Diagnosis diagnosis) {
  diagnosis.withdrawn =
      diagnosis.confusable.empty() ? diagnosis.effect : join(diagnosis.confusable, " or ");
  diagnosis.verdict = Verdict::unknown;
  diagnosis.effect.clear();
  diagnosis.confusable.clear();
  diagnosis.experiment.reset();
  return diagnosis;
}

bool Diagnosis::may_be_noise() const {
  return nothing >= 1 - rules::kNamed;
}

bool Diagnosis::leaves_noise() const {
  return has_static || residual_rms_dph <= (1 + kNoticeable) * noise_floor_dph;
}

bool Diagnosis::is_led_by_catalogue() const {
  return !candidates.empty() && candidates.front().lead > mostly_something_else;
}

std::string Diagnosis::walk_words() const {
  return format(
      "a random walk of the bias of %.2g deg/h/sqrt(h) explains them as well as any effect: one "
      "more run of the programme%s would tell",
      walk_dph_per_rth, has_static ? "" : ", or a recording at rest,");
}

const CandidateFinding* Diagnosis::find(const std::string& name) const {
  const auto found =
      std::find_if(candidates.begin(), candidates.end(),
                   [&](const CandidateFinding& finding) { return finding.effect == name; });
  return found == candidates.end() ? nullptr : &*found;
}

namespace {

const CandidateFinding& best_rival(const Diagnosis& diagnosis) {
  return *diagnosis.find(diagnosis.confusable.front());
}

// Not asked of an event, which explains a moment: with the rest still missing, the fit that
// explains the jump best may leave more elsewhere.
bool lowers_the_error(const Diagnosis& diagnosis, const CandidateFinding& finding) {
  return finding.rms_after_dph < diagnosis.residual_rms_dph || model::is_event(finding.term());
}

bool has_no_effect_twice(std::vector<std::string> effects) {
  std::sort(effects.begin(), effects.end());
  return std::adjacent_find(effects.begin(), effects.end()) == effects.end();
}

}  // namespace

std::vector<std::string> effects_together(const Diagnosis& diagnosis) {
  const CandidateFinding* leader = nullptr;
  if (diagnosis.verdict == Verdict::missing_effect) leader = diagnosis.find(diagnosis.effect);
  if (diagnosis.verdict == Verdict::ambiguous) leader = &best_rival(diagnosis);
  if (leader == nullptr || lowers_the_error(diagnosis, *leader)) return {};
  for (const Diagnosis::Explanation& set : diagnosis.explanations) {
    const bool has_it =
        std::find(set.effects.begin(), set.effects.end(), leader->effect) != set.effects.end();
    if (has_it && set.effects.size() > 1 && has_no_effect_twice(set.effects)) return set.effects;
  }
  return {};
}

std::string effect_to_add(const Diagnosis& diagnosis) {
  if (!effects_together(diagnosis).empty()) return "";
  if (diagnosis.verdict == Verdict::missing_effect) return diagnosis.effect;
  if (diagnosis.verdict == Verdict::ambiguous) {
    const CandidateFinding& best = best_rival(diagnosis);
    return lowers_the_error(diagnosis, best) ? best.effect : "";
  }
  if (diagnosis.verdict != Verdict::unknown || diagnosis.may_be_noise()) return "";
  const auto main = std::find_if(diagnosis.candidates.begin(), diagnosis.candidates.end(),
                                 [&](const CandidateFinding& finding) {
                                   return finding.probability >= rules::kNamed &&
                                          finding.explained_fraction >= kMost &&
                                          lowers_the_error(diagnosis, finding) &&
                                          !model::only_tail_is_seen(finding.term());
                                 });
  return main == diagnosis.candidates.end() ? "" : main->effect;
}

Eigen::VectorXd removed_by_addition_dph(const Diagnosis& diagnosis, const DiagnosisData& data) {
  const CandidateFinding* const finding = diagnosis.find(effect_to_add(diagnosis));
  if (finding == nullptr) return {};
  Eigen::VectorXd removed =
      data.series().drift_dph(finding->completed) - data.series().drift_dph(diagnosis.terms);
  for (const recording::RowRange& recording : data.series().rows().runs()) {
    auto here = series::of_rows(removed, recording);
    here.array() -=
        std::accumulate(here.begin(), here.end(), 0.0) / static_cast<double>(here.size());
  }
  return removed;
}

}  // namespace fogcomp::diagnosis
