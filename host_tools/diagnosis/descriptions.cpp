#include "diagnosis/descriptions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/forms.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"
#include "support/evidence.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

// The argument for `fogcomp add`, including the changed parameter if the effect is already in the
// model.
std::string to_add(const Diagnosis& diagnosis, const std::string& effect) {
  const CandidateFinding* finding = diagnosis.find(effect);
  const auto own = std::find_if(diagnosis.terms.begin(), diagnosis.terms.end(),
                                [&](const model::EffectTerm& term) { return term.name == effect; });
  if (own == diagnosis.terms.end() || finding == nullptr) return effect;
  const model::CatalogueEntry& entry = model::find_effect(effect);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    const double found = finding->term().parameters[i].value;
    if (found == own->parameters[i].value) continue;
    return format("%s:%s=%.4g", effect.c_str(), entry.parameters[i].name, found);
  }
  return effect;
}

// `add` takes an effect once per call: two ripples are two parts of one effect, added one after the
// other.
bool names_twice(const std::vector<std::string>& effects) {
  const std::set<std::string> different(effects.begin(), effects.end());
  return different.size() < effects.size();
}

// Coil temperature, its rate, and the one other input on which the residual depends, if any. Each
// further input would double the number of formulas, and inputs that hardly vary look alike.
fog::InputMask signals_of_formulas(const Diagnosis& diagnosis) {
  const fog::InputDescription* best = nullptr;
  double max = kMost;
  for (const NamedShare& variable : diagnosis.variables) {
    for (const fog::InputDescription& input : fog::kInputTable) {
      const bool beside = fog::beside_temperature(bit_of(input.input)) != 0;
      if (!beside || variable.name != input.column || variable.share < max) continue;
      max = variable.share;
      best = &input;
    }
  }
  fog::InputMask mask = bit_of(fog::Input::temperature) | bit_of(fog::Input::temperature_rate);
  if (best != nullptr) mask |= bit_of(best->input);
  return mask;
}

}  // namespace

std::vector<std::string> without_events(const Diagnosis& diagnosis,
                                        std::vector<std::string> effects) {
  const auto is_event = [&](const std::string& name) {
    const CandidateFinding* const finding = diagnosis.find(name);
    return finding != nullptr && model::is_event(finding->term());
  };
  effects.erase(std::remove_if(effects.begin(), effects.end(), is_event), effects.end());
  return effects;
}

std::vector<std::string> first_events(const Diagnosis& diagnosis,
                                      const std::vector<std::string>& named) {
  std::vector<std::string> events;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    const bool is_first = finding.probability >= rules::kNamed ||
                          std::find(named.begin(), named.end(), finding.effect) != named.end();
    if (is_first && model::is_event(finding.term())) events.push_back(finding.effect);
  }
  return events;
}

std::optional<AdditionRequest> request_of(const Diagnosis& diagnosis,
                                          const std::vector<std::string>& effects) {
  AdditionRequest request;
  for (const std::string& effect : effects) {
    const CandidateFinding* const finding = diagnosis.find(effect);
    if (finding != nullptr && finding->cut) {
      if (effects.size() > 1) return std::nullopt;
      request.cuts = {*finding->cut};
      continue;
    }
    if (finding == nullptr || !finding->is_expression()) {
      request.effects.push_back(to_add(diagnosis, effect));
      continue;
    }
    if (effects.size() > 1) return std::nullopt;
    const model::Expression& expression = finding->term().expression->expression;
    request.expression = expression.name + " = " + expression.text;
  }
  return request;
}

std::vector<Description> rivals_of(const Diagnosis& diagnosis,
                                   const std::vector<std::string>& named) {
  std::vector<Description> descriptions;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    const bool is_event = model::is_event(finding.term());
    if (finding.probability < rules::kNamed || finding.is_expression() || is_event) continue;
    if (named == std::vector<std::string>{finding.effect}) continue;
    descriptions.push_back({*request_of(diagnosis, {finding.effect}),
                            finding.explained_fraction,
                            false,
                            {finding.effect}});
  }
  std::set<std::vector<std::string>> seen{{}, named};
  for (const Diagnosis::Explanation& set : diagnosis.explanations) {
    if (set.complete < rules::kConfusable) continue;
    const std::vector<std::string> effects = without_events(diagnosis, set.effects);
    const bool has_event = effects.size() < set.effects.size();
    if (has_event && effects.size() < 2) continue;
    if (names_twice(effects) || !seen.insert(effects).second) continue;
    if (auto request = request_of(diagnosis, effects)) {
      descriptions.push_back({std::move(*request), set.explained_fraction, false, effects});
    }
  }
  return descriptions;
}

LikelyFormulas likely_formulas(const model::Model& model, const Diagnosis& diagnosis,
                               const DiagnosisData& data, const DiagnosisSettings& settings) {
  std::vector<model::EffectTerm> terms;
  std::map<std::string, FormMeaning> meanings;
  const fog::InputMask signals =
      signals_of_formulas(diagnosis) | (data.inputs() & bit_of(fog::Input::elapsed));
  for (auto& [term, meaning] : formulas_over(data.series(), signals)) {
    // a kink beside a kink
    term.name = term.expression->expression.name = model::free_name(model.terms, term.name);
    meanings[term.name] = meaning;
    terms.push_back(std::move(term));
  }
  const Diagnosis offered = diagnose(model, data.with_offered(terms), settings);
  LikelyFormulas likely;
  likely.chance = offered.nothing;
  likely.show_something = offered.verdict != Verdict::none && !offered.may_be_noise();
  if (!diagnosis.experiment) likely.experiment = offered.experiment;
  std::vector<const CandidateFinding*> described;
  for (const CandidateFinding& finding : offered.candidates) {
    if (!finding.is_expression() || finding.lead < rules::kConfusable) continue;
    likely.forms.push_back({form_text(finding.term().expression->expression),
                            request_of(offered, {finding.effect})->expression,
                            meanings[finding.effect], finding.lead});
    described.push_back(&finding);
  }
  // Fewest parameters first: one more always explains a little more, and has to gain clearly more.
  const auto parameters = [](const CandidateFinding* finding) {
    return model::shape_parameters({finding->term()}).size();
  };
  std::stable_sort(described.begin(), described.end(),
                   [&](const CandidateFinding* a, const CandidateFinding* b) {
                     return parameters(a) < parameters(b);
                   });
  double explained_fraction = 1;
  for (const CandidateFinding* const finding : described) {
    explained_fraction = std::min(explained_fraction, finding->explained_fraction);
    likely.descriptions.push_back({*request_of(offered, {finding->effect}), explained_fraction});
  }
  return likely;
}

}  // namespace fogcomp::diagnosis
