#include "diagnosis/next_step.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/forms.hpp"
#include "model/catalogue.hpp"
#include "support/input_error.hpp"
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

double square(double value) {
  return value * value;
}

// Whether the entry added something to the model; an event only masks rows.
bool is_addition(const model::HistoryEntry& entry) {
  const auto did = [&](const std::string& what) { return entry.action.rfind(what, 0) == 0; };
  const auto is_event = [&](const model::CatalogueEntry& effect) {
    return effect.description.event && did(std::string("add ") + effect.description.name);
  };
  const auto& catalogue = model::catalogue();
  return did("add ") && std::none_of(catalogue.begin(), catalogue.end(), is_event);
}

// The model's error as first fitted, before any addition, deg/h.
double error_when_fitted(const model::Model& model, double now_dph) {
  const auto first = std::find_if(model.history.begin(), model.history.end(), is_addition);
  return first == model.history.end() ? now_dph : first->rms_before_dph;
}

// An addition that removes very little may only correct the inexactness of earlier terms; only a
// run that was not fitted can tell.
bool is_worth_adding(double before_dph, double after_dph, double fitted_dph) {
  const double fall = square(before_dph) - square(after_dph);
  return fall >= rules::kWorthAdding * (square(fitted_dph) - square(after_dph)) ||
         after_dph <= (1 - rules::kHardlyHelps) * before_dph;
}

// Reason not to propose an addition that helps out of sample; "" if there is none.
std::string objection_to(const model::Model& grown, bool has_holdouts) {
  const model::HistoryEntry& step = grown.history.back();
  if (step.rms_after_dph >= step.rms_before_dph) return "it does not lower the error of these runs";
  const double fitted_dph = error_when_fitted(grown, step.rms_before_dph);
  if (has_holdouts || is_worth_adding(step.rms_before_dph, step.rms_after_dph, fitted_dph)) {
    return "";
  }
  return "its gain is so small that it may only correct inexact terms of the model: let a run "
         "that was not fitted decide, with --holdout";
}

// Whether an addition could be worth it if it removed everything above the noise.
bool may_be_worth_adding(const model::Model& model, const Diagnosis& diagnosis) {
  const double now_dph = diagnosis.residual_rms_dph;
  return is_worth_adding(now_dph, std::min(now_dph, diagnosis.noise_floor_dph),
                         error_when_fitted(model, now_dph));
}

// Judges additions as `add` does, without the network.
class Judge {
 public:
  Judge(const model::Model& model, const JudgingRuns& runs, bool run_offsets)
      : model_(model), runs_(runs), run_offsets_(run_offsets) {
    model_.network = {};
  }
  // Refits the model without a change, which all trials need; before trials in several threads.
  void prepare() {
    if (refitted_ || !failure_.empty()) return;
    try {
      fit::AddSettings settings;
      settings.run_offsets = run_offsets_;
      refitted_ = fit::refitted(model_, runs_.training, settings);
    } catch (const InputError& error) {
      failure_ = error.what();
    }
  }

  TriedAddition operator()(AdditionRequest request) {
    prepare();
    TriedAddition trial;
    trial.request = std::move(request);
    trial.request.run_offsets = run_offsets_;
    trial.reason = failure_;
    if (!refitted_) return trial;
    try {
      fit::Addition addition = try_to_add(model_, trial.request, runs_, &*refitted_);
      const std::string objection =
          addition.accepted ? objection_to(addition.model, !runs_.holdouts.empty()) : "";
      trial.accepted = addition.accepted && objection.empty();
      trial.may_be_walk = addition.chance_of_walk.value_or(0) >= fit::rules::kMaxChanceOfWalk;
      trial.reason = objection.empty() ? addition.reason : objection;
      if (addition.out_of_sample) {
        trial.rms_before_dph = addition.out_of_sample->rms_before_dph;
        trial.rms_after_dph = addition.out_of_sample->rms_after_dph;
      }
      if (trial.accepted) trial.model = std::move(addition.model);
    } catch (const InputError& error) {
      trial.reason = error.what();
    }
    return trial;
  }

  // For a description without physics also requires every other run: stretches left out of a run
  // have the temperatures of their neighbours, another run has not.
  TriedAddition of_description(AdditionRequest request) {
    TriedAddition trial = (*this)(std::move(request));
    const std::size_t count = runs_.holdouts.empty() ? runs_.training.runs.size() : 0;
    if (count < 2 || !trial.accepted) return trial;
    std::vector<std::string> objections(count);
    for_each_index(
        count, [&](std::size_t run) { objections[run] = objection_of_run(trial.request, run); });
    const auto objects = [](const std::string& objection) { return !objection.empty(); };
    const auto first = std::find_if(objections.begin(), objections.end(), objects);
    if (first != objections.end()) {
      trial.accepted = false;
      trial.reason = *first;
    }
    return trial;
  }

 private:
  // Reason why the addition, identified on the other runs, fails on this run; "" if it does not, or
  // if the others do not determine it.
  std::string objection_of_run(const AdditionRequest& request, std::size_t run) const {
    try {
      const fit::Addition addition = try_to_add(model_, request, runs_.without(run));
      const auto& judged = addition.out_of_sample;
      if (!judged || judged->rms_after_dph < judged->rms_before_dph) return "";
      return format("it does not hold on %s when that run is left out: %s -> %s deg/h",
                    runs_.training.runs[run].file.c_str(), rounded(judged->rms_before_dph).c_str(),
                    rounded(judged->rms_after_dph).c_str());
    } catch (const InputError&) {
      return "";
    }
  }

  model::Model model_;
  const JudgingRuns& runs_;
  bool run_offsets_;
  std::optional<fit::RefittedModel> refitted_;
  std::string failure_;  // why there is none
};

// Whether the addition is accepted; stores it in `next` in either case.
bool try_out(AdditionRequest request, Judge& judge, NextStep& next) {
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
    return finding != nullptr && (model::info_of(finding->term()).needs &
                                  ~fog::InputMask{bit_of(fog::Input::elapsed)}) != 0;
  });
}

// `add` takes an effect once per call: two ripples are two parts of one effect, added one after the
// other.
bool names_twice(const std::vector<std::string>& effects) {
  const std::set<std::string> different(effects.begin(), effects.end());
  return different.size() < effects.size();
}

// `named` was refused. If a random walk explains as much, sets containing it are not tried.
void add_sets(const Diagnosis& diagnosis, const std::vector<std::string>& named,
              const NextStep& next, std::vector<Description>& descriptions) {
  const bool may_be_walk = !next.refused.empty() && next.refused[0].may_be_walk;
  for (const Diagnosis::Explanation& set : diagnosis.explanations) {
    if (set.effects == named || names_twice(set.effects)) continue;
    if (!events_among(diagnosis, set.effects).empty()) continue;
    const bool is_around = std::all_of(named.begin(), named.end(), [&](const auto& effect) {
      return std::find(set.effects.begin(), set.effects.end(), effect) != set.effects.end();
    });
    if (may_be_walk && is_around) continue;
    const bool is_pliable =
        set.effects.size() > kMaxWithoutOwnInput && has_no_own_input(diagnosis, set.effects);
    if (is_pliable && diagnosis.verdict == Verdict::unknown) continue;
    if (auto request = request_of(diagnosis, set.effects)) {
      descriptions.push_back({std::move(*request), set.explained_fraction, false, set.effects});
    }
  }
}

// Fraction of the mean square above the noise floor that an effect alone takes out.
double removed_alone(const Diagnosis& diagnosis, const CandidateFinding& finding) {
  const double now = square(diagnosis.residual_rms_dph);
  const double above = now - square(diagnosis.noise_floor_dph);
  return above > 0 ? std::min(1.0, (now - square(finding.rms_after_dph)) / above) : 0;
}

// Effects that alone lower the error clearly, whatever their share of what is missing.
void add_singles(const Diagnosis& diagnosis, const std::vector<std::string>& named,
                 std::vector<Description>& descriptions) {
  std::vector<const CandidateFinding*> singles;
  for (const CandidateFinding& finding : diagnosis.candidates) {
    const bool helps =
        finding.rms_after_dph <= (1 - rules::kHardlyHelps) * diagnosis.residual_rms_dph;
    if (helps && !finding.is_expression() && !model::is_event(finding.term()) &&
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

// Tries the first few sets of effects that explain the residual as physics, until one is accepted.
bool try_sets(std::vector<Description> sets, Judge& judge, NextStep& next) {
  if (sets.size() > kMaxTried) sets.resize(kMaxTried);
  for (Description& set : sets) {
    if (!try_out(std::move(set.request), judge, next)) continue;
    if (set.effects.size() > 1) next.together = std::move(set.effects);
    return true;
  }
  return false;
}

// Tries the first few descriptions; of those accepted the one that leaves least out of sample is
// taken, an earlier one if that is nearly as good.
bool describe(std::vector<Description> descriptions, Judge& judge, NextStep& next) {
  if (descriptions.size() > kMaxTried) descriptions.resize(kMaxTried);
  std::vector<TriedAddition> tried(descriptions.size());
  const auto judge_one = [&](std::size_t i) {
    AdditionRequest& request = descriptions[i].request;
    tried[i] = descriptions[i].is_part ? judge(std::move(request))
                                       : judge.of_description(std::move(request));
  };
  judge.prepare();
  for_each_index(tried.size(), judge_one);
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

// Whether most of what is missing may be a function of the signals.
bool is_function_of_signals(const Diagnosis& diagnosis) {
  return diagnosis.fast_share < rules::kMainPart && !diagnosis.walk.may_be_all();
}

// Whether the first refusal, of what the diagnosis names, and the accepted description contradict
// the name.
bool refutes_name(const NextStep& next) {
  if (!next.describes || next.refused.empty()) return false;
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

std::vector<std::string> AdditionRequest::names() const {
  std::vector<std::string> names;
  for (const std::string& effect : effects) names.push_back(effect.substr(0, effect.find(':')));
  if (!expression.empty()) names.push_back(expression.substr(0, expression.find(' ')));
  return names;
}

bool AdditionRequest::is_network() const {
  return names() == std::vector<std::string>{fit::kNetworkName};
}

JudgingRuns JudgingRuns::without(std::size_t run) const {
  JudgingRuns others = *this;
  const auto left_out = others.training.runs.begin() + static_cast<std::ptrdiff_t>(run);
  others.holdouts = {std::move(*left_out)};
  others.training.runs.erase(left_out);
  return others;
}

fit::Addition try_to_add(const model::Model& model, const AdditionRequest& request,
                         const JudgingRuns& runs, const fit::RefittedModel* before) {
  const fit::EffectChange change = request.expression.empty()
                                       ? fit::change_effects(model.terms, request.effects)
                                       : fit::change_expression(model.terms, request.expression);
  fit::AddSettings settings;
  settings.run_offsets = request.run_offsets;
  settings.verdict_only = true;
  settings.before = before;
  return fit::add_effect(model, change, runs.training, runs.holdouts, settings);
}

NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, const JudgingRuns& runs,
                        const DiagnosisSettings& settings) {
  NextStep next;
  if (diagnosis.verdict == Verdict::none) return next;
  next.little_is_left = runs.holdouts.empty() && !may_be_worth_adding(model, diagnosis);
  if (next.little_is_left) return next;
  std::vector<std::string> named = effects_together(diagnosis);
  if (const std::string one = effect_to_add(diagnosis); !one.empty()) named = {one};
  const std::vector<std::string> events = events_among(diagnosis, named);
  if (!events.empty()) named = events;
  Judge judge(model, runs, settings.run_offsets);
  std::vector<Description> descriptions;
  if (diagnosis.verdict != Verdict::unknown) {
    if (!named.empty() && try_out(*request_of(diagnosis, named), judge, next)) {
      if (named.size() > 1) next.together = named;
      return next;
    }
    // The catalogue explains the residual: its sets, most probable first.
    add_sets(diagnosis, named, next, descriptions);
    if (try_sets(std::move(descriptions), judge, next)) return next;
    descriptions.clear();
  } else {
    if (!named.empty()) {
      descriptions.push_back(
          {*request_of(diagnosis, named), diagnosis.find(named[0])->explained_fraction, true});
    }
    if (is_function_of_signals(diagnosis)) add_sets(diagnosis, named, next, descriptions);
  }
  if (!diagnosis.walk.may_be_all()) add_singles(diagnosis, named, descriptions);
  if (is_function_of_signals(diagnosis)) {
    add_formulas(model, diagnosis, data, settings, next, descriptions);
  }
  sort_by_explained(descriptions);
  const bool described = describe(std::move(descriptions), judge, next);
  next.together.clear();
  next.refutes_name = described && diagnosis.verdict != Verdict::unknown && refutes_name(next);
  if (!described && may_learn(model, diagnosis, runs)) {
    next.describes = true;
    try_out({{fit::kNetworkName}, ""}, judge, next);
  }
  return next;
}

}  // namespace fogcomp::diagnosis
