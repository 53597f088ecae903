#include "diagnosis/ladder.hpp"

#include <algorithm>

namespace fogcomp {
namespace {

// Fall of chi^2 below which a term is not needed beside the others.
constexpr double kNeeded = 15;

// The term that the loop added and needs least, if it does not need it.
std::vector<EffectTerm>::iterator superfluous(std::vector<EffectTerm>& terms,
                                              const Diagnosis& diagnosis,
                                              const std::vector<std::string>& added) {
  auto least = terms.end();
  double least_gain = kNeeded;
  for (auto term = terms.begin(); term != terms.end(); ++term) {
    if (std::find(added.begin(), added.end(), term->name) == added.end()) continue;
    const double gain = diagnosis.term_gain[static_cast<std::size_t>(term - terms.begin())];
    if (gain >= least_gain) continue;
    least_gain = gain;
    least = term;
  }
  return least;
}

}  // namespace

std::vector<std::string> Ladder::added() const {
  std::vector<std::string> names;
  for (const Step& step : steps) {
    if (step.removed) {
      names.erase(std::find(names.begin(), names.end(), step.effect));
    } else if (std::find(names.begin(), names.end(), step.effect) == names.end()) {
      names.push_back(step.effect);
    }
  }
  return names;
}

Ladder walk_ladder(const Model& model, const DiagnosisData& data, int most_effects,
                   const DiagnosisSettings& settings) {
  Ladder ladder;
  Model grown = model;
  ladder.first = diagnose(grown, data, settings);
  ladder.last = ladder.first;
  for (int i = 0; i < most_effects; ++i) {
    const bool named = ladder.last.verdict == Verdict::missing_effect;
    if (!named && ladder.last.verdict != Verdict::ambiguous) break;
    const std::string effect = named ? ladder.last.effect : ladder.last.confusable.front();
    const auto finding =
        std::find_if(ladder.last.candidates.begin(), ladder.last.candidates.end(),
                     [&](const CandidateFinding& one) { return one.effect == effect; });
    Ladder::Step step;
    step.effect = effect;
    if (!named) {
      step.alternatives.assign(ladder.last.confusable.begin() + 1, ladder.last.confusable.end());
    }
    step.rms_before_dph = ladder.last.residual_rms_dph;
    grown.terms = finding->completed;
    ladder.last = diagnose(grown, data, settings);
    step.rms_after_dph = ladder.last.residual_rms_dph;
    ladder.steps.push_back(step);

    grown.terms = ladder.last.terms;
    const auto unneeded = superfluous(grown.terms, ladder.last, ladder.added());
    if (unneeded == grown.terms.end() || unneeded->name == effect) continue;
    Ladder::Step removal;
    removal.effect = unneeded->name;
    removal.removed = true;
    removal.rms_before_dph = ladder.last.residual_rms_dph;
    grown.terms.erase(unneeded);
    ladder.last = diagnose(grown, data, settings);
    removal.rms_after_dph = ladder.last.residual_rms_dph;
    ladder.steps.push_back(removal);
  }
  ladder.terms = ladder.last.terms;
  return ladder;
}

}  // namespace fogcomp
