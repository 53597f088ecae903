#include "diagnosis/ladder.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

#include "diagnosis/model_fit.hpp"
#include "fit/turn_on_bias.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Ladder::Step step_of(const NextStep& next, const Diagnosis& before) {
  Ladder::Step step{*next.addition, next.describes, {}};
  if (before.verdict != Verdict::ambiguous) return step;
  const std::vector<std::string> names = step.addition.request.names();
  for (const std::string& rival : before.confusable) {
    if (!holds(names, rival)) step.alternatives.push_back(rival);
  }
  return step;
}

// A trial excludes the network.
model::Model with_network(const model::Model& before, const TriedAddition& addition,
                          const JudgingRuns& runs) {
  if (!before.network.present()) return *addition.model;
  return try_to_add(before, addition.request, runs).model;
}

// The line in time for which an effect was refused, if it is significant. Several runs show by
// themselves whether it goes on from one to the next.
std::optional<LineInTime> refused_line(const model::Model& model, const DiagnosisData& data,
                                       const JudgingRuns& runs, const NextStep& next,
                                       const std::optional<noise::NoiseModel>& noise) {
  const std::size_t count = runs.training.runs.size() + runs.holdouts.size();
  if (count > 1 || !next.refused_line()) return std::nullopt;
  const auto line = find_line_in_time(data, fit_for_diagnosis(model, data, noise));
  return line && line->is_significant() ? line : std::nullopt;
}

// Each power-on has a bias of its own here once additions are judged so.
class RowsOfLadder {
 public:
  explicit RowsOfLadder(const DiagnosisData& given) : given_(given) {}

  const DiagnosisData& with(bool own_biases) {
    const series::Rows& rows = given_.series().rows();
    if (!own_biases || !rows.keeps_bias || rows.restart_rows.empty()) return given_;
    if (!own_) own_.emplace(given_).keep_bias(false);
    return *own_;
  }

 private:
  const DiagnosisData& given_;
  std::optional<DiagnosisData> own_;
};

// A diagnosis of a model and, if that is wanted, what to do next.
struct Look {
  Diagnosis diagnosis;
  NextStep next;
};

enum class Wanted { diagnosis, refinement, next_step };

Look look_once(const model::Model& model, const DiagnosisData& data, AdditionJudge& judge,
               const DiagnosisSettings& settings, Wanted wanted) {
  Look look;
  judge.go_on_from(model);
  std::atomic<bool> is_complete{false};
  for_each_index(wanted == Wanted::diagnosis ? 1 : 2, [&](std::size_t i) {
    if (i == 1 && !is_complete) judge.prepare();
    if (i == 1) return;
    look.diagnosis = diagnose(model, data, settings);
    is_complete = look.diagnosis.verdict == Verdict::none;
  });
  if (wanted == Wanted::refinement) look.next = find_refinement(model, judge);
  if (wanted != Wanted::next_step) return look;
  DiagnosisSettings unheard = settings;
  unheard.progress = nullptr;
  look.next = find_next_step(model, look.diagnosis, data, judge, unheard);
  if (look.next.chance_of_forms) shown_by_formulas(look.diagnosis, *look.next.chance_of_forms);
  if (look.next.name_is != Refuted::no) withdraw_name(look.diagnosis, look.next.name_is);
  look.diagnosis.line = refused_line(model, data, judge.runs(), look.next, settings.noise);
  return look;
}

bool may_have_own_biases(const AdditionJudge& judge) {
  return !judge.gives_own_biases() && judge.runs().have_several_power_ons();
}

// Whether what is missing has found no name that holds with one bias for all power-ons.
bool finds_no_name(const Look& look) {
  return look.diagnosis.verdict != Verdict::none && !look.next.little_is_left &&
         (!look.next.addition || look.next.describes);
}

// Whether the biases of the power-ons certainly differ with the addition in the model: one for all
// bends its effects.
bool shows_own_biases(const NextStep& next, const JudgingRuns& runs) {
  return next.addition && fit::certain_turn_on(*next.addition->model, runs.all());
}

// A missing effect may hide that the biases of the power-ons differ; then one bias for all refuses
// or bends what is missing. Where it finds no name, or one beside which the biases differ, the same
// is looked at with a bias for each, and `judge` goes on so if the biases certainly differ or only
// that finds something. Errors out of sample do not decide: those about a bias of each power-on are
// smaller in any case.
Look look_at(const model::Model& model, RowsOfLadder& rows, AdditionJudge& judge,
             const DiagnosisSettings& settings, Wanted wanted) {
  Look common = look_once(model, rows.with(judge.gives_own_biases()), judge, settings, wanted);
  if (wanted != Wanted::next_step || !may_have_own_biases(judge)) return common;
  const bool is_certain = shows_own_biases(common.next, judge.runs());
  if (!is_certain && !finds_no_name(common)) return common;
  judge.give_own_biases(true);
  Look own = look_once(model, rows.with(true), judge, settings, wanted);
  own.next.only_with_own_biases = own.next.addition && (is_certain || !common.next.addition ||
                                                        shows_own_biases(own.next, judge.runs()));
  if (own.next.only_with_own_biases) return own;
  judge.give_own_biases(false);
  return common;
}

}  // namespace

std::vector<std::string> Ladder::names(bool described) const {
  std::vector<std::string> all;
  for (const Step& step : steps) {
    if (step.describes != described) continue;
    for (const std::string& name : step.addition.request.names()) {
      if (!holds(all, name)) all.push_back(name);
    }
  }
  return all;
}

Ladder stepwise_selection(const model::Model& model, const DiagnosisData& data,
                          const JudgingRuns& runs, int max_steps,
                          const DiagnosisSettings& settings) {
  int added = 0;
  double shown = 0;  // a refinement takes the time of a step and is none
  DiagnosisSettings each = settings;
  each.progress = [&](double part) {
    shown = std::max(shown, (added + part) / (max_steps + 1.0));
    if (settings.progress) settings.progress(shown);
  };
  Ladder ladder;
  ladder.model = model;
  AdditionJudge judge(model, runs, settings.run_offsets);
  RowsOfLadder rows(data);
  Look look = look_at(model, rows, judge, each, Wanted::next_step);
  ladder.first = std::move(look.diagnosis);
  ladder.next = std::move(look.next);
  ladder.last = ladder.first;
  ladder.last_next = ladder.next;
  while (max_steps > 0 && ladder.last_next.addition) {
    ladder.steps.push_back(step_of(ladder.last_next, ladder.last));
    const TriedAddition& addition = ladder.steps.back().addition;
    const bool is_network = addition.request.is_network();
    if (!addition.request.refines) ++added;
    ladder.model = with_network(ladder.model, addition, runs);
    ladder.is_cut_off = !is_network && added == max_steps;
    look = look_at(ladder.model, rows, judge, each,
                   is_network          ? Wanted::diagnosis
                   : ladder.is_cut_off ? Wanted::refinement
                                       : Wanted::next_step);
    ladder.last = std::move(look.diagnosis);
    const std::vector<TriedAddition> refused = std::move(ladder.last_next.refused);
    ladder.last_next = std::move(look.next);
    if (is_network) {  // its effects are those with which all other additions were refused
      ladder.last_next.refused = refused;
      break;
    }
  }
  return ladder;
}

}  // namespace fogcomp::diagnosis
