#include "diagnosis/next_step.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/forms.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

// Limit for sets of effects of temperature and time alone if the catalogue does not explain the
// residual: on one programme three of them can imitate nearly everything.
constexpr std::size_t kMaxWithoutOwnInput = 2;
constexpr std::size_t kMaxTried = 6;  // descriptions; each needs a fit and a cross-validation
constexpr std::size_t kMaxSingles = 3;

// The argument for `fogcomp add`, including the changed parameter if the effect is already in the
// model.
std::string to_add(const Diagnosis& diagnosis, const std::string& effect) {
  const CandidateFinding* finding = diagnosis.find(effect);
  const auto own = std::find_if(diagnosis.terms.begin(), diagnosis.terms.end(),
                                [&](const model::EffectTerm& term) { return term.name == effect; });
  if (own == diagnosis.terms.end() || finding == nullptr) return effect;
  if (model::is_event(*own)) return effect;  // one more event
  const model::CatalogueEntry& entry = model::find_effect(effect);
  for (std::size_t i = 0; i < entry.parameters.size(); ++i) {
    if (finding->term().parameters[i] == own->parameters[i]) continue;
    return format("%s:%s=%.4g", effect.c_str(), entry.parameters[i].name,
                  finding->term().parameters[i]);
  }
  return effect;
}

// The one to be added first or, if only a set is named, all of them.
std::vector<std::string> named_effects(const Diagnosis& diagnosis) {
  const std::string one = effect_to_add(diagnosis);
  return one.empty() ? effects_together(diagnosis) : std::vector<std::string>{one};
}

std::vector<std::string> events_among(const Diagnosis& diagnosis,
                                      const std::vector<std::string>& effects) {
  std::vector<std::string> events;
  for (const std::string& name : effects) {
    const CandidateFinding* const finding = diagnosis.find(name);
    if (finding != nullptr && model::is_event(finding->term())) events.push_back(name);
  }
  return events;
}

// An expression must be the only addition: `add` takes effects, or one expression.
std::optional<AdditionRequest> request_of(const Diagnosis& diagnosis,
                                          const std::vector<std::string>& effects) {
  AdditionRequest request;
  for (const std::string& effect : effects) {
    const CandidateFinding* const finding = diagnosis.find(effect);
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

// Whether an addition could be worth it if it removed everything above the noise.
bool may_be_worth_adding(const model::Model& model, const Diagnosis& diagnosis) {
  const double now_dph = diagnosis.residual_rms_dph;
  return is_worth_adding(now_dph, std::min(now_dph, diagnosis.noise_floor_dph),
                         error_when_fitted(model, now_dph));
}

// Whether the addition is accepted; stores it in `next` in either case.
bool try_out(AdditionRequest request, AdditionJudge& judge, NextStep& next) {
  TriedAddition addition =
      next.describes ? judge.of_description(std::move(request)) : judge(std::move(request));
  const bool accepted = addition.accepted;
  if (accepted) {
    next.addition = std::move(addition);
  } else {
    next.refused.push_back(std::move(addition));
  }
  return accepted;
}

// A possible description of the residual and the fraction it explains.
struct Description {
  AdditionRequest request;
  double explained_fraction = 0;
  bool is_part = false;  // a certain part of the missing drift, the rest being unknown
  std::vector<std::string> effects{};  // names of a set
};

// Whether all of them are functions of temperature and time alone.
bool has_no_own_input(const Diagnosis& diagnosis, const std::vector<std::string>& effects) {
  return std::none_of(effects.begin(), effects.end(), [&](const std::string& effect) {
    const CandidateFinding* const finding = diagnosis.find(effect);
    return finding != nullptr && model::has_own_input(finding->term());
  });
}

// `add` takes an effect once per call: two ripples are two parts of one effect, added one after the
// other.
bool names_twice(const std::vector<std::string>& effects) {
  const std::set<std::string> different(effects.begin(), effects.end());
  return different.size() < effects.size();
}

// `named` was refused: other effects that are as certainly missing.
std::vector<Description> certain_ones(const Diagnosis& diagnosis,
                                      const std::vector<std::string>& named) {
  std::vector<Description> descriptions;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    const bool is_event = model::is_event(finding.term());
    if (finding.probability < rules::kNamed || finding.is_expression() || is_event) continue;
    if (std::find(named.begin(), named.end(), finding.effect) != named.end()) continue;
    descriptions.push_back({*request_of(diagnosis, {finding.effect}), finding.explained_fraction});
  }
  return descriptions;
}

std::vector<std::string> without_events(const Diagnosis& diagnosis,
                                        std::vector<std::string> effects) {
  for (const std::string& event : events_among(diagnosis, effects))
    effects.erase(std::find(effects.begin(), effects.end(), event));
  return effects;
}

// `named` was refused. A walk is no reason to leave out sets with it: beside more of what is
// missing there may be nothing left for a walk to explain. Events are added one at a time and
// found anew by each fit: a set with one is tried without it if two effects are left (single ones
// are tried where they help clearly), and not beside an effect that is a certain part, which comes
// first.
void add_sets(const Diagnosis& diagnosis, const std::vector<std::string>& named,
              std::vector<Description>& descriptions) {
  const bool has_part =
      diagnosis.verdict == Verdict::unknown && events_among(diagnosis, named).size() < named.size();
  std::set<std::vector<std::string>> seen{{}, named};
  for (const Diagnosis::Explanation& set : diagnosis.explanations) {
    const std::vector<std::string> effects = without_events(diagnosis, set.effects);
    const bool has_event = effects.size() < set.effects.size();
    if (has_event && (has_part || effects.size() < 2)) continue;
    if (names_twice(effects) || !seen.insert(effects).second) continue;
    const bool is_pliable =
        effects.size() > kMaxWithoutOwnInput && has_no_own_input(diagnosis, effects);
    if (is_pliable && diagnosis.verdict == Verdict::unknown) continue;
    if (auto request = request_of(diagnosis, effects)) {
      descriptions.push_back({std::move(*request), set.explained_fraction, false, effects});
    }
  }
}

// Fraction of the mean square above the noise floor that an effect alone takes out.
double removed_alone(const Diagnosis& diagnosis, const CandidateFinding& finding) {
  const double now = std::pow(diagnosis.residual_rms_dph, 2);
  const double above = now - std::pow(diagnosis.noise_floor_dph, 2);
  return above > 0 ? std::min(1.0, (now - std::pow(finding.rms_after_dph, 2)) / above) : 0;
}

// Effects that alone lower the error clearly, whatever their share of what is missing.
void add_singles(const Diagnosis& diagnosis, const std::vector<std::string>& named,
                 std::vector<Description>& descriptions) {
  std::vector<const CandidateFinding*> singles;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    if (helps_clearly(diagnosis, finding) && !finding.is_expression() &&
        !model::only_tail_is_seen(finding.term()) &&
        named != std::vector<std::string>{finding.effect}) {
      singles.push_back(&finding);
    }
  }
  const auto less = [](const CandidateFinding* a, const CandidateFinding* b) {
    return a->rms_after_dph < b->rms_after_dph;
  };
  std::stable_sort(singles.begin(), singles.end(), less);
  if (singles.size() > kMaxSingles) singles.resize(kMaxSingles);
  for (const CandidateFinding* const single : singles) {
    descriptions.push_back(
        {*request_of(diagnosis, {single->effect}), removed_alone(diagnosis, *single)});
  }
}

// Coil temperature, its rate, and the one other input on which the residual depends, if any. Each
// further input would double the number of formulas, and inputs that hardly vary look alike.
fog::InputMask signals_of_formulas(const Diagnosis& diagnosis) {
  const fog::InputDescription* best = nullptr;
  double max = rules::kMinShareOfInput;
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

void add_formulas(const model::Model& model, const Diagnosis& diagnosis, const DiagnosisData& data,
                  const DiagnosisSettings& settings, NextStep& next,
                  std::vector<Description>& descriptions) {
  const std::vector<model::EffectTerm> formulas =
      formulas_over(data.series(), signals_of_formulas(diagnosis));
  const Diagnosis offered = diagnose(model, data.with_offered(formulas), settings);
  if (!diagnosis.experiment) next.experiment = offered.experiment;
  double explained_fraction = 1;
  for (const CandidateFinding& finding : offered.candidates) {
    if (!finding.is_expression() || finding.lead < rules::kConfusable) continue;
    const AdditionRequest request = *request_of(offered, {finding.effect});
    next.forms.push_back(
        {form_text(finding.term().expression->expression), request.expression, finding.lead});
    // a parameter more always explains a little more
    explained_fraction = std::min(explained_fraction, finding.explained_fraction);
    descriptions.push_back({request, explained_fraction});
  }
}

// Tries what the diagnosis names. `is_one`: it names a single effect and no rival.
bool try_named(const Diagnosis& diagnosis, const std::vector<std::string>& named, bool is_one,
               AdditionJudge& judge, NextStep& next) {
  if (named.empty()) return false;
  AdditionRequest request = *request_of(diagnosis, named);
  request.may_be_little = is_one;
  if (!try_out(std::move(request), judge, next)) return false;
  if (named.size() > 1) next.together = named;
  return true;
}

// Tries the first few sets of effects that explain the residual as physics, until one is accepted.
bool try_sets(std::vector<Description> sets, AdditionJudge& judge, NextStep& next) {
  if (sets.size() > kMaxTried) sets.resize(kMaxTried);
  for (Description& set : sets) {
    if (!try_out(std::move(set.request), judge, next)) continue;
    if (set.effects.size() > 1) next.together = std::move(set.effects);
    return true;
  }
  return false;
}

// The catalogue explains the residual, but not by what is named: its sets, most probable first.
bool try_instead(const Diagnosis& diagnosis, const std::vector<std::string>& named,
                 AdditionJudge& judge, NextStep& next) {
  std::vector<Description> sets;
  add_sets(diagnosis, named, sets);
  return try_sets(std::move(sets), judge, next) ||
         try_sets(certain_ones(diagnosis, named), judge, next);
}

// Whether no other description could leave clearly less than this one.
bool leaves_noise(const TriedAddition& tried, double noise_floor_dph, const JudgingRuns& runs) {
  return tried.accepted && runs.holdouts.empty() &&
         rules::kClearlyLess * tried.rms_after_dph <= noise_floor_dph;
}

// Tries the first few descriptions; of those accepted the one that leaves least out of sample is
// taken, an earlier one if that is nearly as good.
bool describe(const Diagnosis& diagnosis, std::vector<Description> descriptions,
              AdditionJudge& judge, NextStep& next) {
  if (descriptions.size() > kMaxTried) descriptions.resize(kMaxTried);
  std::vector<TriedAddition> tried(descriptions.size());
  const auto judge_one = [&](std::size_t i) {
    AdditionRequest& request = descriptions[i].request;
    tried[i] = descriptions[i].is_part ? judge(std::move(request))
                                       : judge.of_description(std::move(request));
  };
  if (!tried.empty()) judge_one(0);  // with all threads: often it is the one
  if (!tried.empty() && leaves_noise(tried[0], diagnosis.noise_floor_dph, judge.runs())) {
    tried.resize(1);
  } else if (!tried.empty()) {
    for_each_index(tried.size() - 1, [&](std::size_t i) { judge_one(i + 1); });
  }
  std::size_t best = tried.size();
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!tried[i].accepted) continue;
    if (best == tried.size() || tried[i].left() < rules::kClearlyLess * tried[best].left()) {
      best = i;
    }
  }
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!tried[i].accepted) next.refused.push_back(std::move(tried[i]));
  }
  if (best == tried.size()) {
    next.describes = true;
    return false;
  }
  next.describes = !descriptions[best].is_part;
  next.addition = std::move(tried[best]);
  return true;
}

void sort_by_explained(std::vector<Description>& descriptions) {
  std::stable_sort(descriptions.begin(), descriptions.end(), [](const auto& a, const auto& b) {
    return a.explained_fraction > b.explained_fraction;
  });
}

// Whether the most probable set needs an event beside what is named. An event explains whatever the
// name leaves: a formula that needs none may be the truth.
bool needs_event(const Diagnosis& diagnosis, const std::vector<std::string>& named) {
  if (diagnosis.explanations.empty()) return false;
  const std::vector<std::string>& likeliest = diagnosis.explanations.front().effects;
  const std::size_t events = events_among(diagnosis, likeliest).size();
  return events > 0 && events < likeliest.size() && events_among(diagnosis, named).empty();
}

// Tries formulas against a name; none unless they are more certain than names have to be.
bool try_forms(const model::Model& model, const Diagnosis& diagnosis, const DiagnosisData& data,
               const DiagnosisSettings& settings, AdditionJudge& judge, NextStep& next) {
  NextStep instead;
  std::vector<Description> formulas;
  add_formulas(model, diagnosis, data, settings, instead, formulas);
  double probability = 0;
  for (const Form& form : instead.forms) probability += form.share;
  if (probability < rules::kNamed || !describe(diagnosis, std::move(formulas), judge, instead))
    return false;
  instead.name_is = Refuted::by_formula;
  next = std::move(instead);
  return true;
}

// Whether most of what is missing may be a function of the signals.
bool is_function_of_signals(const Diagnosis& diagnosis) {
  return !is_mainly_fast(diagnosis) && !diagnosis.walk.may_be_all();
}

// Whether the first refusal, of what the diagnosis names, and the accepted description contradict
// the name.
bool refutes_name(const Diagnosis& diagnosis, const NextStep& next) {
  if (diagnosis.verdict == Verdict::unknown || !next.describes || next.refused.empty())
    return false;
  const TriedAddition& named = next.refused.front();
  const bool helps_hardly = named.left() > 1 - rules::kHardlyHelps && !named.may_be_walk;
  return named.rms_before_dph > 0 && helps_hardly &&
         next.addition->left() < rules::kRefutes * named.left();
}

// Whether a network may learn what is missing. Within one run the inputs follow a single path, so
// it is undetermined beside it.
bool may_learn(const model::Model& model, const Diagnosis& diagnosis, const JudgingRuns& runs) {
  const bool has_other_runs = runs.training.runs.size() > 1 || !runs.holdouts.empty();
  return has_other_runs && is_function_of_signals(diagnosis) && !model.network.present();
}

}  // namespace

bool NextStep::refused_line() const {
  return std::any_of(refused.begin(), refused.end(),
                     [](const TriedAddition& one) { return one.may_be_line; });
}

NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, AdditionJudge& judge,
                        const DiagnosisSettings& settings) {
  const JudgingRuns& runs = judge.runs();
  NextStep next;
  if (diagnosis.verdict == Verdict::none) return next;
  std::vector<std::string> named = named_effects(diagnosis);
  const bool is_one = diagnosis.verdict == Verdict::missing_effect && named.size() == 1;
  const bool is_little = runs.holdouts.empty() && !may_be_worth_adding(model, diagnosis);
  next.little_is_left = is_little && !is_one;
  if (next.little_is_left) return next;
  const std::vector<std::string> events = events_among(diagnosis, named);
  if (!events.empty()) named = events;
  std::vector<Description> descriptions;
  if (diagnosis.verdict != Verdict::unknown) {
    const bool may_be_formula = !is_little && needs_event(diagnosis, named);
    if (may_be_formula && try_forms(model, diagnosis, data, settings, judge, next)) return next;
    if (try_named(diagnosis, named, is_one, judge, next) || is_little) return next;
    if (try_instead(diagnosis, named, judge, next)) return next;
  } else {
    if (!named.empty()) {
      descriptions.push_back(
          {*request_of(diagnosis, named), diagnosis.find(named[0])->explained_fraction, true});
    }
    if (is_function_of_signals(diagnosis)) add_sets(diagnosis, named, descriptions);
  }
  if (!diagnosis.walk.may_be_all()) add_singles(diagnosis, named, descriptions);
  if (is_function_of_signals(diagnosis)) {
    add_formulas(model, diagnosis, data, settings, next, descriptions);
  } else if (diagnosis.late_ripple) {
    descriptions.push_back({{{}, *diagnosis.late_ripple}, diagnosis.fast_share});
  }
  sort_by_explained(descriptions);
  const bool described = describe(diagnosis, std::move(descriptions), judge, next);
  next.together.clear();
  if (described && refutes_name(diagnosis, next)) next.name_is = Refuted::out_of_sample;
  if (!described && may_learn(model, diagnosis, runs)) {
    next.describes = true;
    try_out({{fit::kNetworkName}, ""}, judge, next);
  }
  return next;
}

}  // namespace fogcomp::diagnosis
