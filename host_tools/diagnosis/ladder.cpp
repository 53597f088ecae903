#include "diagnosis/ladder.hpp"

#include <algorithm>

#include "diagnosis/decision_rules.hpp"

namespace fogcomp::diagnosis {
namespace {

// The term that the loop added and needs least, if it does not need it.
std::vector<model::EffectTerm>::iterator superfluous(std::vector<model::EffectTerm>& terms,
                                                     const Diagnosis& diagnosis,
                                                     const std::vector<std::string>& added) {
  auto least = terms.end();
  double least_gain = rules::kNeeded;
  for (auto term = terms.begin(); term != terms.end(); ++term) {
    if (std::find(added.begin(), added.end(), term->name) == added.end()) continue;
    const double gain = diagnosis.term_gain[static_cast<std::size_t>(term - terms.begin())];
    if (gain >= least_gain) continue;
    least_gain = gain;
    least = term;
  }
  return least;
}

double square(double value) {
  return value * value;
}

Ladder::Step step_of(const std::string& effect, const Diagnosis& before) {
  Ladder::Step step;
  step.effect = effect;
  step.rms_before_dph = before.residual_rms_dph;
  if (before.verdict != Verdict::ambiguous) return step;
  for (const std::string& other : before.confusable) {
    if (other != effect) step.alternatives.push_back(other);
  }
  return step;
}

// What takes out so little of all may be the inexactness of what is there.
bool is_worth_adding(const Ladder& ladder, const Ladder::Step& step) {
  const double fall = square(step.rms_before_dph) - square(step.rms_after_dph);
  const double excess = square(ladder.first.residual_rms_dph) - square(step.rms_after_dph);
  return ladder.steps.empty() || fall >= rules::kWorthAdding * excess;
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

Ladder walk_ladder(const model::Model& model, const DiagnosisData& data, int most_effects,
                   const DiagnosisSettings& settings) {
  Ladder ladder;
  model::Model grown = model;
  double before = 0;
  DiagnosisSettings each = settings;
  each.progress = [&](double done) {
    if (settings.progress) settings.progress((before + done) / (most_effects + 1.0));
  };
  ladder.first = diagnose(grown, data, each);
  ladder.last = ladder.first;
  for (int i = 0; i < most_effects; ++i) {
    before = i + 1.0;
    const std::string effect = effect_to_add(ladder.last);
    if (effect.empty()) break;
    Ladder::Step step = step_of(effect, ladder.last);
    grown.terms = ladder.last.find(effect)->completed;
    Diagnosis next = diagnose(grown, data, each);
    step.rms_after_dph = next.residual_rms_dph;
    if (!is_worth_adding(ladder, step)) {
      ladder.left_alone = effect;
      break;
    }
    ladder.last = std::move(next);
    ladder.steps.push_back(step);

    grown.terms = ladder.last.terms;
    const auto unneeded = superfluous(grown.terms, ladder.last, ladder.added());
    if (unneeded == grown.terms.end() || unneeded->name == effect) continue;
    Ladder::Step removal{unneeded->name, true, {}, ladder.last.residual_rms_dph, 0};
    grown.terms.erase(unneeded);
    ladder.last = diagnose(grown, data, each);
    removal.rms_after_dph = ladder.last.residual_rms_dph;
    ladder.steps.push_back(removal);
  }
  ladder.terms = ladder.last.terms;
  return ladder;
}

}  // namespace fogcomp::diagnosis
