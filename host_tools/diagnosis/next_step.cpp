#include "diagnosis/next_step.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnosis/addition_judge.hpp"
#include "model/effect_list.hpp"
#include "model/model.hpp"
#include "support/evidence.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

AdditionRequest refinement(const model::EffectTerm& term, const std::string& settings) {
  AdditionRequest request{{term.name + ":" + settings}, ""};
  request.refines = true;
  return request;
}

// Frees one thing that the formula of a term leaves out or keeps: the one that leaves least out of
// sample. All together only where that is clearly better.
std::optional<TriedAddition> refined(const model::EffectTerm& term, const AdditionJudge& judge) {
  const std::vector<std::string> settings = model::possible_refinements(term);
  const AdditionRequest together = refinement(term, join(settings, ","));
  if (settings.empty() || !judge.may_help(together)) return std::nullopt;
  std::optional<TriedAddition> best;
  for (const std::string& one : settings) {
    const AdditionRequest request = refinement(term, one);
    if (settings.size() > 1 && !judge.may_help(request)) continue;
    TriedAddition tried = judge(request);
    if (tried.accepted && (!best || tried.score.gain > best->score.gain)) best = std::move(tried);
  }
  if (settings.size() == 1) return best;
  TriedAddition all = judge(together);
  if (all.accepted && (!best || all.is_clearly_better(*best))) best = std::move(all);
  return best;
}

// Of what frees something that the formulas of the model's own effects leave out, or keep at a
// value (model::possible_refinements()), the accepted one that leaves least out of sample. Nothing
// if none is accepted.
std::optional<TriedAddition> best_refinement(const model::Model& model,
                                             const AdditionJudge& judge) {
  std::optional<TriedAddition> best;
  for (const model::EffectTerm& term : model.terms) {
    std::optional<TriedAddition> tried = refined(term, judge);
    if (tried && (!best || tried->score.gain > best->score.gain)) best = std::move(tried);
  }
  return best;
}

constexpr std::size_t kMaxTried = 6;  // descriptions; each needs a fit and a cross-validation

// The one to be added first or, if only a set is named, all of them.
std::vector<std::string> named_effects(const Diagnosis& diagnosis) {
  const std::string one = effect_to_add(diagnosis);
  return one.empty() ? effects_together(diagnosis) : std::vector<std::string>{one};
}

// Whether trials side by side would take too much memory: each needs a hundred columns.
bool is_large(const runs::Runs& runs) {
  constexpr std::size_t kMaxBlocks = 20'000;
  std::size_t blocks = 0;
  for (const runs::Run& run : runs.training) blocks += run.blocks.blocks.size();
  return blocks > kMaxBlocks;
}

std::vector<Description> joined(std::vector<Description> all, std::vector<Description> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
  return all;
}

std::vector<Description> first_few(std::vector<Description> all) {
  if (all.size() > kMaxTried) all.resize(kMaxTried);
  return all;
}

// Whether most of what is missing may be a function of the signals. An input rate is as fast as
// cycles: a table that steps makes them of what depends on its rate.
bool is_function_of_signals(const Diagnosis& diagnosis) {
  const bool has_rate =
      std::any_of(diagnosis.variables.begin(), diagnosis.variables.end(),
                  [](const NamedShare& variable) { return variable.name == "input_rate_dph"; });
  return (!is_mainly_fast(diagnosis) || has_rate) && !diagnosis.may_be_noise();
}

// Whether what is left may be slow noise, by these runs alone, and enough to hide an effect.
bool noise_may_hide(const Diagnosis& diagnosis) {
  return diagnosis.may_be_noise() && !is_mainly_fast(diagnosis) &&
         diagnosis.residual_rms_dph > (1 + kNoticeable) * diagnosis.noise.white_dph();
}

/// Tries what a diagnosis proposes, until something is accepted. What was tried is in `next_`.
class StepSearch {
 public:
  StepSearch(const model::Model& model, const Diagnosis& diagnosis, const DiagnosisData& data,
             const AdditionJudge& judge, const DiagnosisSettings& settings)
      : model_(model),
        diagnosis_(diagnosis),
        data_(data),
        judge_(judge),
        settings_(settings),
        is_unknown_(diagnosis.verdict == Verdict::unknown),
        named_(named_effects(diagnosis)),
        events_(first_events(diagnosis, named_)) {
    named_ = without_events(diagnosis, std::move(named_));
  }

  NextStep operator()() {
    const bool nothing_describes = diagnosis_.verdict != Verdict::none && !explains();
    if (!next_.addition && noise_may_hide(diagnosis_)) try_what_noise_hides();
    if (may_be_refined()) refine();
    if (!next_.addition && nothing_describes && may_learn()) {
      next_.describes = true;
      keep(judge_({{fit::kNetworkName}, ""}));
    }
    next_.refutes_name = diagnosis_.verdict != Verdict::none && !is_unknown_ &&
                         !next_.refused.empty() && (!next_.addition || next_.describes);
    return std::move(next_);
  }

 private:
  // Tries names, their rivals, certain jumps, and descriptions; false if none holds.
  bool explains() {
    if (!is_unknown_ && is_named(named_)) return true;
    const bool has_rivals = diagnosis_.is_led_by_catalogue() && !diagnosis_.may_be_noise();
    if (has_rivals && is_one_of(first_few(rivals_of(diagnosis_, named_)))) return true;
    return is_named(events_) || is_described_by(possible_descriptions());
  }

  // Whether the addition is accepted; stores it in either case.
  bool keep(TriedAddition tried) {
    const bool accepted = tried.accepted;
    if (accepted) {
      next_.addition = std::move(tried);
    } else {
      next_.refused.push_back(std::move(tried));
    }
    return accepted;
  }

  bool was_refused(const AdditionRequest& request) const {
    return std::any_of(next_.refused.begin(), next_.refused.end(), [&](const TriedAddition& tried) {
      return !request.effects.empty() && tried.request.effects == request.effects;
    });
  }

  // All of them or, if one brings nothing beside the others, these.
  bool is_named(std::vector<std::string> effects) {
    while (!effects.empty()) {
      const std::optional<AdditionRequest> request = request_of(diagnosis_, effects);
      if (!request || was_refused(*request)) return false;
      if (keep(judge_(*request))) break;
      const std::string& needless = next_.refused.back().needless;
      if (needless.empty()) return false;
      effects.erase(std::remove(effects.begin(), effects.end(), needless), effects.end());
    }
    if (effects.size() > 1) next_.together = effects;
    return !effects.empty();
  }

  // What is named was refused: tries its rivals.
  bool is_one_of(const std::vector<Description>& rivals) {
    return std::any_of(rivals.begin(), rivals.end(),
                       [&](const Description& rival) { return is_named(rival.effects); });
  }

  // Whether no other description could leave clearly less than this one.
  bool leaves_noise(const TriedAddition& tried) const {
    return tried.accepted && judge_.runs().holdouts.empty() &&
           tried.rms_after_dph <= diagnosis_.noise_floor_dph;
  }

  // Tries the first few descriptions; of those accepted the one that gains most is taken, an
  // earlier one if that is nearly as good.
  bool is_described_by(std::vector<Description> descriptions) {
    descriptions = first_few(std::move(descriptions));
    std::vector<TriedAddition> tried = all_tried(descriptions);
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (!tried[i].accepted) {
        next_.refused.push_back(std::move(tried[i]));
      } else if (!next_.addition || tried[i].is_clearly_better(*next_.addition)) {
        next_.addition = std::move(tried[i]);
        next_.describes = !descriptions[i].is_part;
      }
    }
    return next_.addition.has_value();
  }

  std::vector<TriedAddition> all_tried(const std::vector<Description>& descriptions) {
    std::vector<TriedAddition> tried(descriptions.size());
    const auto judge_one = [&](std::size_t i) { tried[i] = judge_(descriptions[i].request); };
    if (tried.empty()) return tried;
    judge_one(0);  // with all threads: often it is the one
    if (leaves_noise(tried[0])) {
      tried.resize(1);
    } else if (is_large(judge_.runs())) {
      for (std::size_t i = 1; i < tried.size(); ++i) judge_one(i);
    } else {
      for_each_index(tried.size() - 1, [&](std::size_t i) { judge_one(i + 1); });
    }
    return tried;
  }

  // What may describe the residual, those that explain most first: a certain part of what is
  // missing, formulas, or ripples where most is a cycle.
  std::vector<Description> possible_descriptions() {
    std::vector<Description> all;
    if (is_unknown_ && !named_.empty()) {
      all.push_back(
          {*request_of(diagnosis_, named_), diagnosis_.find(named_[0])->explained_fraction, true});
    }
    if (is_function_of_signals(diagnosis_)) {
      LikelyFormulas formulas = likely_formulas(model_, diagnosis_, data_, settings_);
      next_.forms = std::move(formulas.forms);
      next_.experiment = std::move(formulas.experiment);
      all = joined(std::move(all), std::move(formulas.descriptions));
    } else {
      for (const std::string& ripple : diagnosis_.late_ripples) {
        all.push_back({{{}, ripple}, diagnosis_.fast_share});
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Description& a, const Description& b) {
      return a.explained_fraction > b.explained_fraction;
    });
    return all;
  }

  // Formulas compete with slow noise as effects do: one may stand out in which no effect does.
  void try_what_noise_hides() {
    LikelyFormulas formulas = likely_formulas(model_, diagnosis_, data_, settings_);
    if (!formulas.show_something || !is_described_by(std::move(formulas.descriptions))) return;
    next_.forms = std::move(formulas.forms);
    next_.experiment = std::move(formulas.experiment);
    next_.chance_of_forms = formulas.chance;
  }

  // Whether nothing is to be added, or a formula that says nothing of the cause.
  bool may_be_refined() const {
    return !next_.addition || (next_.describes && !next_.addition->request.expression.empty());
  }

  // What is left may be what the formulas of the model's own effects leave out. A refinement
  // replaces a formula that does not leave clearly less: it has a cause.
  void refine() {
    std::optional<TriedAddition> best = best_refinement(model_, judge_);
    if (!best || (next_.addition && next_.addition->is_clearly_better(*best))) return;
    next_.addition = std::move(best);
    next_.describes = true;
  }

  // Whether a network may learn what is missing. Within one run the inputs follow a single path, so
  // it is undetermined beside it.
  bool may_learn() const {
    const bool has_other_runs =
        judge_.runs().training.size() > 1 || !judge_.runs().holdouts.empty();
    return has_other_runs && is_function_of_signals(diagnosis_) && !model_.network.present();
  }

  const model::Model& model_;
  const Diagnosis& diagnosis_;
  const DiagnosisData& data_;
  const AdditionJudge& judge_;
  const DiagnosisSettings& settings_;
  bool is_unknown_;
  std::vector<std::string> named_;   // what the diagnosis names, but for events
  std::vector<std::string> events_;  // the first of those
  NextStep next_;
};

}  // namespace

NextStep find_refinement(const model::Model& model, const AdditionJudge& judge) {
  NextStep next;
  next.addition = best_refinement(model, judge);
  next.describes = next.addition.has_value();
  return next;
}

NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, const AdditionJudge& judge,
                        const DiagnosisSettings& settings) {
  return StepSearch(model, diagnosis, data, judge, settings)();
}

}  // namespace fogcomp::diagnosis
