#include "diagnosis/next_step.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

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

// Whether trials side by side would take too much memory: each needs a hundred columns.
bool is_large(const runs::Runs& runs) {
  constexpr std::size_t kMaxBlocks = 20'000;
  std::size_t blocks = 0;
  for (const runs::Run& run : runs.training) blocks += run.blocks.blocks.size();
  return blocks > kMaxBlocks;
}

// The effect of a description that goes on while the power is off, if there is one power-on: all
// stretches of it share its time, so that none shows what is left at the next. A name has physics
// for it. "": none.
std::string effect_of_one_power_on(const AdditionRequest& request, const runs::Runs& runs) {
  if (runs.have_several_power_ons()) return "";
  for (const std::string& effect : request.effects) {
    const model::EffectTerm term = model::parse_effects(effect).front();
    if (model::info_of(term).outlives_power) return term.name;
  }
  return "";
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
  const bool may_be_noise = diagnosis.verdict == Verdict::none
                                ? !diagnosis.blind_spot.empty()
                                : diagnosis.may_be_noise() && !is_mainly_fast(diagnosis);
  return may_be_noise &&
         diagnosis.residual_rms_dph > (1 + kNoticeable) * diagnosis.noise.white_dph();
}

/// Tries what a diagnosis proposes, until something is accepted. What was tried is in `next_`.
class StepSearch {
 public:
  StepSearch(const model::Model& model, const Diagnosis& diagnosis, const DiagnosisData& data,
             AdditionJudge& judge, const DiagnosisSettings& settings)
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
    return std::move(next_);
  }

 private:
  // Tries names and descriptions; false if no description holds.
  bool explains() {
    if ((!is_unknown_ || !events_.empty()) && is_what_is_named()) return true;
    if (!is_unknown_ &&
        is_one_of(certain_ones(diagnosis_, named_), sets_of_effects(diagnosis_, named_)) &&
        leaves_noise(*next_.addition)) {
      return true;
    }
    if (!next_.addition && is_named(events_)) return true;
    const bool described = is_described_by(possible_descriptions());
    if (described && !next_.describes) return true;
    if (refutes_name(described)) next_.name_is = Refuted::out_of_sample;
    return described;
  }

  bool is_what_is_named() {
    const bool may_be_formula = is_unknown_ || needs_event(diagnosis_) || needs_second_part();
    return (may_be_formula && is_formula()) || (!is_unknown_ && is_named(named_)) ||
           has_higher_order() || is_rival();
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

  bool is_named(const std::vector<std::string>& effects) {
    if (effects.empty() || !keep(judge_(*request_of(diagnosis_, effects)))) return false;
    if (effects.size() > 1) next_.together = effects;
    return true;
  }

  // The effect that is named was refused: what a higher order leaves may have refused the first.
  bool has_higher_order() {
    if (named_.size() != 1 || diagnosis_.verdict != Verdict::missing_effect) return false;
    const AdditionRequest first = *request_of(diagnosis_, named_);
    if (first.effects.size() != 1) return false;
    for (const std::string& effect : higher_orders(first.effects.front())) {
      if (keep(judge_({{effect}, ""}))) return true;
    }
    return false;
  }

  // The first of several that cannot be told apart was refused: another may hold. On several runs
  // each judges as the first was, because other programmes would show it wrong; on one it must hold
  // as a description.
  bool is_rival() {
    if (diagnosis_.verdict != Verdict::ambiguous || judge_.runs().training.size() < 2) return false;
    for (const std::string& rival : diagnosis_.confusable) {
      if (named_ == std::vector<std::string>{rival}) continue;
      if (keep(judge_(*request_of(diagnosis_, {rival})))) return true;
    }
    return false;
  }

  // The catalogue explains the residual, but not by what is named: tries the first few of some
  // sets, then of others, in its place, as uncertain as descriptions, until one is accepted.
  bool is_one_of(std::vector<Description> some, std::vector<Description> others) {
    for (Description& set : joined(first_few(std::move(some)), first_few(std::move(others)))) {
      if (!keep(judge_(std::move(set.request)))) continue;
      if (set.effects.size() > 1) next_.together = std::move(set.effects);
      return true;
    }
    return false;
  }

  // Whether no other description could leave clearly less than this one.
  bool leaves_noise(const TriedAddition& tried) const {
    return tried.accepted && judge_.runs().holdouts.empty() &&
           tried.rms_after_dph <= diagnosis_.noise_floor_dph;
  }

  // Tries the first few descriptions; of those accepted the one that leaves least out of sample is
  // taken, an earlier one if that is nearly as good. The addition that is there is the first.
  bool is_described_by(std::vector<Description> descriptions) {
    next_.describes = !next_.addition;
    descriptions = first_few(std::move(descriptions));
    std::vector<TriedAddition> tried = all_tried(descriptions);
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (!tried[i].accepted) {
        next_.refused.push_back(std::move(tried[i]));
      } else if (!next_.addition || tried[i].is_clearly_better(*next_.addition)) {
        next_.addition = std::move(tried[i]);
        next_.describes = !descriptions[i].is_part;
        next_.together.clear();
      }
    }
    return next_.addition.has_value();
  }

  std::vector<TriedAddition> all_tried(const std::vector<Description>& descriptions) {
    std::vector<TriedAddition> tried(descriptions.size());
    const auto judge_one = [&](std::size_t i) { tried[i] = tried_as_description(descriptions[i]); };
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

  TriedAddition tried_as_description(const Description& description) {
    TriedAddition tried = judge_(description.request);
    const std::string effect =
        tried.accepted ? effect_of_one_power_on(tried.request, judge_.runs()) : "";
    if (effect.empty()) return tried;
    tried.accepted = false;
    tried.reason = effect +
                   " goes on while the power is off, and one run cannot tell what is left of it "
                   "at the next power-on: a second run beside the first, or as holdout, would";
    return tried;
  }

  // Whether an effect of temperature and time is named in two parts, which imitate nearly
  // everything on one programme.
  bool needs_second_part() const {
    return std::any_of(named_.begin(), named_.end(), [&](const std::string& effect) {
      const CandidateFinding* const finding = diagnosis_.find(effect);
      return finding != nullptr && model::has_second_part(finding->term()) &&
             !model::has_own_input(finding->term());
    });
  }

  // Diagnosed when first asked: that takes as long as the first diagnosis.
  const LikelyFormulas& formulas() {
    if (!formulas_) formulas_ = likely_formulas(model_, diagnosis_, data_, settings_);
    return *formulas_;
  }

  void tell_formulas() {
    next_.forms = formulas().forms;
    next_.experiment = formulas().experiment;
  }

  // Tries formulas against a name; none unless they are more certain than names have to be.
  bool is_formula() {
    double probability = 0;
    for (const Form& form : formulas().forms) probability += form.share;
    if (probability < rules::kNamed) return false;
    NextStep before = std::exchange(next_, {});
    tell_formulas();
    if (!is_described_by(formulas().descriptions)) {
      next_ = std::move(before);
      return false;
    }
    if (!is_unknown_) next_.name_is = Refuted::by_formula;
    return true;
  }

  // What may describe the residual, those that explain most first: with what is named, a certain
  // part of what is missing, or refused.
  std::vector<Description> possible_descriptions() {
    std::vector<Description> all;
    const bool is_function = is_function_of_signals(diagnosis_);
    if (is_unknown_ && !named_.empty() && events_among(diagnosis_, named_).empty()) {
      all.push_back(
          {*request_of(diagnosis_, named_), diagnosis_.find(named_[0])->explained_fraction, true});
    }
    if (is_unknown_ && is_function) {
      all = joined(std::move(all), sets_of_effects(diagnosis_, named_));
    }
    if (!diagnosis_.may_be_noise()) {
      all = joined(std::move(all), single_effects(diagnosis_, named_));
    }
    if (is_function) {
      tell_formulas();
      all = joined(std::move(all), formulas().descriptions);
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

  // Whether the refusal of what the diagnosis names contradicts the name: it raises the error far
  // from the rows fitted, a description leaves far less out of sample, or nothing is accepted at
  // all.
  bool refutes_name(bool described) const {
    const auto refused =
        std::find_if(next_.refused.begin(), next_.refused.end(),
                     [&](const TriedAddition& one) { return one.request.names() == named_; });
    if (is_unknown_ || refused == next_.refused.end()) return false;
    if (refused->rms_before_dph <= 0) return false;
    if (refused->fails_far) return true;
    return !described || next_.addition->is_clearly_better(*refused);
  }

  // Among formulas as well: one may stand out of the slow noise in which no effect of the catalogue
  // does.
  void try_what_noise_hides() {
    if (!formulas().show_something || formulas().forms.empty()) return;
    tell_formulas();
    next_.chance_of_forms = formulas().chance;
    is_described_by(formulas().descriptions);
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
  AdditionJudge& judge_;
  const DiagnosisSettings& settings_;
  bool is_unknown_;
  std::vector<std::string> named_;   // what the diagnosis names, but for events
  std::vector<std::string> events_;  // the first of those
  std::optional<LikelyFormulas> formulas_;
  NextStep next_;
};

}  // namespace

NextStep find_refinement(const model::Model& model, AdditionJudge& judge) {
  NextStep next;
  next.addition = best_refinement(model, judge);
  next.describes = next.addition.has_value();
  return next;
}

NextStep find_next_step(const model::Model& model, const Diagnosis& diagnosis,
                        const DiagnosisData& data, AdditionJudge& judge,
                        const DiagnosisSettings& settings) {
  return StepSearch(model, diagnosis, data, judge, settings)();
}

}  // namespace fogcomp::diagnosis
