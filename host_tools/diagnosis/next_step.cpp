#include "diagnosis/next_step.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/refinement.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/evidence.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr std::size_t kMaxTried = 6;  // descriptions; each needs a fit and a cross-validation

// The one to be added first or, if only a set is named, all of them.
std::vector<std::string> named_effects(const Diagnosis& diagnosis) {
  const std::string one = effect_to_add(diagnosis);
  return one.empty() ? effects_together(diagnosis) : std::vector<std::string>{one};
}

// Whether the addition is accepted; stores it in `next` in either case.
bool keep(TriedAddition tried, NextStep& next) {
  const bool accepted = tried.accepted;
  if (accepted) {
    next.addition = std::move(tried);
  } else {
    next.refused.push_back(std::move(tried));
  }
  return accepted;
}

// Likewise for what has not been tried.
bool try_out(AdditionRequest request, AdditionJudge& judge, NextStep& next) {
  return keep(judge(std::move(request)), next);
}

// Tries what the diagnosis names.
bool try_named(const Diagnosis& diagnosis, const std::vector<std::string>& named,
               AdditionJudge& judge, NextStep& next) {
  if (named.empty() || !try_out(*request_of(diagnosis, named), judge, next)) return false;
  if (named.size() > 1) next.together = named;
  return true;
}

// The next orders of an effect as `add` takes it: {"scale_factor_temperature:order=2", ...}.
std::vector<std::string> higher_orders(const std::string& effect) {
  const model::EffectTerm term = model::parse_effects(effect).front();
  std::vector<std::string> orders;
  const auto& parameters = model::find_effect(term.name).parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].scale != fog::Scale::whole) continue;
    for (int order = static_cast<int>(term.parameters[i].value) + 1;
         order <= parameters[i].max_milli / 1000; ++order) {
      orders.push_back(term.name + format(":%s=%d", parameters[i].name, order));
    }
  }
  return orders;
}

// The effect that is named was refused: what a higher order leaves may have refused the first.
bool try_higher_orders(const Diagnosis& diagnosis, const std::vector<std::string>& named,
                       AdditionJudge& judge, NextStep& next) {
  if (named.size() != 1 || diagnosis.verdict != Verdict::missing_effect) return false;
  const AdditionRequest first = *request_of(diagnosis, named);
  if (first.effects.size() != 1) return false;
  for (const std::string& effect : higher_orders(first.effects.front())) {
    if (keep(judge({{effect}, ""}), next)) return true;
  }
  return false;
}

// The first of several that cannot be told apart was refused: another may hold. On several runs
// each judges as the first was, because other programmes would show it wrong; on one it must hold
// as a description.
bool try_rivals(const Diagnosis& diagnosis, const std::vector<std::string>& named,
                AdditionJudge& judge, NextStep& next) {
  if (diagnosis.verdict != Verdict::ambiguous || judge.runs().training.size() < 2) {
    return false;
  }
  for (const std::string& rival : diagnosis.confusable) {
    if (named == std::vector<std::string>{rival}) continue;
    if (keep(judge(*request_of(diagnosis, {rival})), next)) return true;
  }
  return false;
}

// The catalogue explains the residual, but not by what is named: tries the first few sets in its
// place, as uncertain as descriptions, until one is accepted.
bool try_sets(std::vector<Description> sets, AdditionJudge& judge, NextStep& next) {
  if (sets.size() > kMaxTried) sets.resize(kMaxTried);
  for (Description& set : sets) {
    if (!keep(judge(std::move(set.request)), next)) continue;
    if (set.effects.size() > 1) next.together = std::move(set.effects);
    return true;
  }
  return false;
}

// Whether no other description could leave clearly less than this one.
bool leaves_noise(const TriedAddition& tried, double noise_floor_dph, const runs::Runs& runs) {
  return tried.accepted && runs.holdouts.empty() && tried.rms_after_dph <= noise_floor_dph;
}

// Whether trials side by side would take too much memory: each needs a hundred columns.
bool is_large(const runs::Runs& runs) {
  constexpr std::size_t kMaxBlocks = 20'000;
  std::size_t blocks = 0;
  for (const runs::Run& run : runs.training) blocks += run.blocks.blocks.size();
  return blocks > kMaxBlocks;
}

// Refuses a description by an effect that goes on while the power is off if there is one power-on:
// all stretches of it share its time, so that none shows what is left at the next. A name has
// physics for it.
void refuse_if_of_one_power_on(const runs::Runs& runs, TriedAddition& tried) {
  if (!tried.accepted || runs.have_several_power_ons()) return;
  for (const std::string& effect : tried.request.effects) {
    const model::EffectTerm term = model::parse_effects(effect).front();
    if (!model::info_of(term).outlives_power) continue;
    tried.accepted = false;
    tried.reason = term.name +
                   " goes on while the power is off, and one run cannot tell what is left of it "
                   "at the next power-on: a second run beside the first, or as holdout, would";
  }
}

// Tries the first few descriptions; of those accepted the one that leaves least out of sample is
// taken, an earlier one if that is nearly as good. The addition that `next` has is the first.
bool describe(const Diagnosis& diagnosis, std::vector<Description> descriptions,
              AdditionJudge& judge, NextStep& next) {
  next.describes = !next.addition;
  if (descriptions.empty()) return next.addition.has_value();
  if (descriptions.size() > kMaxTried) descriptions.resize(kMaxTried);
  std::vector<TriedAddition> tried(descriptions.size());
  const auto judge_one = [&](std::size_t i) {
    tried[i] = judge(std::move(descriptions[i].request));
    refuse_if_of_one_power_on(judge.runs(), tried[i]);
  };
  judge_one(0);  // with all threads: often it is the one
  if (leaves_noise(tried[0], diagnosis.noise_floor_dph, judge.runs())) {
    tried.resize(1);
  } else if (is_large(judge.runs())) {
    for (std::size_t i = 1; i < tried.size(); ++i) judge_one(i);
  } else {
    for_each_index(tried.size() - 1, [&](std::size_t i) { judge_one(i + 1); });
  }
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (!tried[i].accepted) {
      next.refused.push_back(std::move(tried[i]));
    } else if (!next.addition || tried[i].is_clearly_better(*next.addition)) {
      next.addition = std::move(tried[i]);
      next.describes = !descriptions[i].is_part;
      next.together.clear();
    }
  }
  return next.addition.has_value();
}

void append(std::vector<Description> more, std::vector<Description>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

// Whether an effect of temperature and time is named in two parts, which imitate nearly everything
// on one programme.
bool needs_second_part(const Diagnosis& diagnosis, const std::vector<std::string>& named) {
  return std::any_of(named.begin(), named.end(), [&](const std::string& effect) {
    const CandidateFinding* const finding = diagnosis.find(effect);
    return finding != nullptr && model::has_second_part(finding->term()) &&
           !model::has_own_input(finding->term());
  });
}

// Diagnoses with formulas when first asked: that takes as long as the first diagnosis.
using AskFormulas = std::function<const LikelyFormulas&()>;

void tell(const LikelyFormulas& formulas, NextStep& next) {
  next.forms = formulas.forms;
  next.experiment = formulas.experiment;
}

// Tries formulas against a name; none unless they are more certain than names have to be.
bool try_forms(const Diagnosis& diagnosis, const LikelyFormulas& formulas, AdditionJudge& judge,
               NextStep& next) {
  double probability = 0;
  for (const Form& form : formulas.forms) probability += form.share;
  NextStep instead;
  tell(formulas, instead);
  if (probability < rules::kNamed || !describe(diagnosis, formulas.descriptions, judge, instead)) {
    return false;
  }
  if (diagnosis.verdict != Verdict::unknown) instead.name_is = Refuted::by_formula;
  next = std::move(instead);
  return true;
}

// Whether most of what is missing may be a function of the signals. An input rate is as fast as
// cycles: a table that steps makes them of what depends on its rate.
bool is_function_of_signals(const Diagnosis& diagnosis) {
  const bool has_rate =
      std::any_of(diagnosis.variables.begin(), diagnosis.variables.end(),
                  [](const NamedShare& variable) { return variable.name == "input_rate_dph"; });
  return (!is_mainly_fast(diagnosis) || has_rate) && !diagnosis.may_be_noise();
}

// What may describe the residual, those that explain most first. `named`: a certain part of what is
// missing, or refused.
std::vector<Description> possible_descriptions(const Diagnosis& diagnosis,
                                               const std::vector<std::string>& named,
                                               const AskFormulas& formulas, NextStep& next) {
  std::vector<Description> all;
  const bool is_unknown = diagnosis.verdict == Verdict::unknown;
  const bool is_function = is_function_of_signals(diagnosis);
  if (is_unknown && !named.empty() && events_among(diagnosis, named).empty()) {
    all.push_back(
        {*request_of(diagnosis, named), diagnosis.find(named[0])->explained_fraction, true});
  }
  if (is_unknown && is_function) append(sets_of_effects(diagnosis, named), all);
  if (!diagnosis.may_be_noise()) append(single_effects(diagnosis, named), all);
  if (is_function) {
    tell(formulas(), next);
    append(formulas().descriptions, all);
  } else {
    for (const std::string& ripple : diagnosis.late_ripples) {
      all.push_back({{{}, ripple}, diagnosis.fast_share});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Description& a, const Description& b) {
    return a.explained_fraction > b.explained_fraction;
  });
  return all;
}

// What is left may be what the formulas of the model's own effects leave out. A refinement replaces
// a formula that does not leave clearly less: it has a cause.
void refine(const model::Model& model, AdditionJudge& judge, NextStep& next) {
  std::optional<TriedAddition> best = best_refinement(model, judge);
  if (!best || (next.addition && next.addition->is_clearly_better(*best))) {
    return;
  }
  next.addition = std::move(best);
  next.describes = true;
}

// Whether nothing is to be added, or a formula that says nothing of the cause.
bool may_be_refined(const NextStep& next) {
  return !next.addition || (next.describes && !next.addition->request.expression.empty());
}

// Whether the refusal of what the diagnosis names contradicts the name: it raises the error far
// from the rows fitted, a description leaves far less out of sample, or nothing is accepted at all.
bool refutes_name(const Diagnosis& diagnosis, const std::vector<std::string>& named, bool described,
                  const NextStep& next) {
  const auto refused =
      std::find_if(next.refused.begin(), next.refused.end(),
                   [&](const TriedAddition& one) { return one.request.names() == named; });
  if (diagnosis.verdict == Verdict::unknown || refused == next.refused.end()) return false;
  if (refused->rms_before_dph <= 0) return false;
  if (refused->fails_far) return true;
  return !described || next.addition->is_clearly_better(*refused);
}

// Whether a network may learn what is missing. Within one run the inputs follow a single path, so
// it is undetermined beside it.
bool may_learn(const model::Model& model, const Diagnosis& diagnosis, const runs::Runs& runs) {
  const bool has_other_runs = runs.training.size() > 1 || !runs.holdouts.empty();
  return has_other_runs && is_function_of_signals(diagnosis) && !model.network.present();
}

// Whether what is left may be slow noise, by these runs alone, and enough to hide an effect.
bool noise_may_hide(const Diagnosis& diagnosis) {
  const bool may_be_noise = diagnosis.verdict == Verdict::none
                                ? !diagnosis.blind_spot.empty()
                                : diagnosis.may_be_noise() && !is_mainly_fast(diagnosis);
  return may_be_noise &&
         diagnosis.residual_rms_dph > (1 + kNoticeable) * diagnosis.noise.white_dph();
}

// Among formulas as well: one may stand out of the slow noise in which no effect of the catalogue
// does.
void try_what_noise_hides(const model::Model& model, const Diagnosis& diagnosis,
                          const DiagnosisData& data, AdditionJudge& judge,
                          const DiagnosisSettings& settings, NextStep& next) {
  const LikelyFormulas formulas = likely_formulas(model, diagnosis, data, settings);
  if (!formulas.show_something || formulas.forms.empty()) return;
  tell(formulas, next);
  next.chance_of_forms = formulas.chance;
  describe(diagnosis, formulas.descriptions, judge, next);
}

// Tries names and descriptions; false if no description holds.
bool try_what_may_be_missing(const model::Model& model, const Diagnosis& diagnosis,
                             const DiagnosisData& data, AdditionJudge& judge,
                             const DiagnosisSettings& settings, NextStep& next) {
  std::vector<std::string> named = named_effects(diagnosis);
  const std::vector<std::string> events = first_events(diagnosis, named);
  named = without_events(diagnosis, std::move(named));
  const bool is_unknown = diagnosis.verdict == Verdict::unknown;
  std::optional<LikelyFormulas> likely;
  const AskFormulas formulas = [&]() -> const LikelyFormulas& {
    if (!likely) likely = likely_formulas(model, diagnosis, data, settings);
    return *likely;
  };
  if (!is_unknown || !events.empty()) {
    const bool may_be_formula =
        is_unknown || needs_event(diagnosis) || needs_second_part(diagnosis, named);
    if (may_be_formula && try_forms(diagnosis, formulas(), judge, next)) return true;
    if (!is_unknown && try_named(diagnosis, named, judge, next)) return true;
    if (try_higher_orders(diagnosis, named, judge, next)) return true;
    if (try_rivals(diagnosis, named, judge, next)) return true;
  }
  if (!is_unknown && (try_sets(certain_ones(diagnosis, named), judge, next) ||
                      try_sets(sets_of_effects(diagnosis, named), judge, next))) {
    if (leaves_noise(*next.addition, diagnosis.noise_floor_dph, judge.runs())) return true;
  }
  if (!next.addition && try_named(diagnosis, events, judge, next)) return true;
  const bool described =
      describe(diagnosis, possible_descriptions(diagnosis, named, formulas, next), judge, next);
  if (described && !next.describes) return true;
  if (refutes_name(diagnosis, named, described, next)) next.name_is = Refuted::out_of_sample;
  return described;
}

}  // namespace

NextStep find_refinement(const model::Model& model, AdditionJudge& judge) {
  NextStep next;
  refine(model, judge, next);
  return next;
}

NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, AdditionJudge& judge,
                        const DiagnosisSettings& settings) {
  NextStep next;
  bool nothing_describes = false;
  if (diagnosis.verdict != Verdict::none) {
    nothing_describes = !try_what_may_be_missing(model, diagnosis, data, judge, settings, next);
  }
  if (!next.addition && noise_may_hide(diagnosis)) {
    try_what_noise_hides(model, diagnosis, data, judge, settings, next);
  }
  if (may_be_refined(next)) refine(model, judge, next);
  if (!next.addition && nothing_describes && may_learn(model, diagnosis, judge.runs())) {
    next.describes = true;
    try_out({{fit::kNetworkName}, ""}, judge, next);
  }
  return next;
}

}  // namespace fogcomp::diagnosis
