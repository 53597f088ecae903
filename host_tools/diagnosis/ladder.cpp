#include "diagnosis/ladder.hpp"

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "fit/turn_on_bias.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"

namespace fogcomp::diagnosis {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Ladder::Step step_of(const NextStep& next, const Diagnosis& before) {
  Ladder::Step step{*next.addition, next.describes, {}};
  const std::vector<std::string> names = step.addition.request.names();
  const bool is_rival = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
    return holds(before.confusable, name);
  });
  if (before.verdict != Verdict::ambiguous || !is_rival) return step;
  for (const std::string& rival : before.confusable) {
    if (!holds(names, rival)) step.alternatives.push_back(rival);
  }
  return step;
}

// A trial excludes the network.
model::Model with_network(const model::Model& before, const TriedAddition& addition,
                          const runs::Runs& runs) {
  if (!before.network.present()) return *addition.model;
  return try_to_add(before, addition.request, runs).model;
}

// The effect that is named: of what is certainly missing the part that is proposed; of several,
// what explains most alone.
std::string leading_effect(const NextStep& next, const Diagnosis& diagnosis) {
  const bool is_named = diagnosis.verdict == Verdict::missing_effect;
  if (!next.addition || next.describes || !is_named) return diagnosis.effect;
  const CandidateFinding* first = nullptr;
  for (const std::string& name : next.addition->request.names()) {
    const CandidateFinding* const finding = diagnosis.find(name);
    if (finding == nullptr || finding->probability < rules::kNamed) continue;
    if (first == nullptr || finding->explained_fraction > first->explained_fraction) {
      first = finding;
    }
  }
  return first == nullptr ? diagnosis.effect : first->effect;
}

// A diagnosis of a model and, if that is wanted, what to do next.
struct Look {
  Diagnosis diagnosis;
  NextStep next;
};

enum class Wanted { diagnosis, refinement, next_step };

// Whether what is missing has found no name that holds with one bias for all power-ons.
bool finds_no_name(const Look& look) {
  return look.diagnosis.verdict != Verdict::none && (!look.next.addition || look.next.describes);
}

bool biases_differ(const model::Model& model, const runs::Runs& runs) {
  return fit::turn_on_biases(model, runs.all()).differs;
}

// Looks at one model after the other, with the biases that the looks before have found.
class Looks {
 public:
  Looks(const model::Model& model, const DiagnosisData& data, const runs::Runs& runs,
        DiagnosisSettings settings)
      : data_(data), settings_(std::move(settings)), judge_(model, runs, settings_.run_offsets) {}

  Look at(const model::Model& model, Wanted wanted) {
    Look look = once(model, wanted);
    if (wanted != Wanted::next_step || !runs().have_several_power_ons()) return look;
    if (judge_.bias_of() != series::BiasOf::power_on) {
      if (auto own = with_own_biases(look, model)) return std::move(*own);
    }
    if (look.next.addition) return look;
    const compare::TurnOn turn_on = fit::turn_on_biases(model, runs().all());
    if (!turn_on.differs) return look;
    if (auto between = between_recordings(model)) return std::move(*between);
    std::string& blind_spot = look.diagnosis.blind_spot;
    if (blind_spot.empty() && turn_on.first_certain() == nullptr) {
      blind_spot = turn_on.doubt_words();
    }
    return look;
  }

  const runs::Runs& runs() const { return judge_.runs(); }
  void cut(const std::vector<recording::Cut>& cuts) {
    judge_.go_on_with(runs().with(cuts));
    cut_ = data_.with_runs(runs().training);
  }

 private:
  // With biases as the judge has them.
  Look once(const model::Model& model, Wanted wanted) {
    const DiagnosisData data = (cut_ ? *cut_ : data_).with_bias_of(judge_.bias_of());
    Look look;
    judge_.go_on_from(model);
    std::atomic<bool> is_complete{false};
    for_each_index(wanted == Wanted::diagnosis ? 1 : 2, [&](std::size_t i) {
      if (i == 1 && !is_complete) judge_.prepare();
      if (i == 1) return;
      look.diagnosis = diagnose(model, data, settings_);
      is_complete = look.diagnosis.verdict == Verdict::none;
    });
    if (wanted == Wanted::refinement) look.next = find_refinement(model, judge_);
    if (wanted != Wanted::next_step) return look;
    DiagnosisSettings unheard = settings_;
    unheard.progress = nullptr;
    look.next = find_next_step(model, look.diagnosis, data, judge_, unheard);
    if (look.next.chance_of_forms) {
      look.diagnosis = shown_by_formulas(std::move(look.diagnosis), *look.next.chance_of_forms);
    }
    if (look.next.refutes_name) look.diagnosis = without_name(std::move(look.diagnosis));
    look.diagnosis.effect = leading_effect(look.next, look.diagnosis);
    return look;
  }

  // A missing effect may hide that the biases of the power-ons differ; then one bias for all
  // refuses or bends what is missing. Where it finds no name, or one beside which the biases
  // differ, the same is looked at with a bias for each, and it goes on so if the biases differ or
  // only that finds something. Errors out of sample do not decide: those about a bias of each
  // power-on are smaller in any case.
  std::optional<Look> with_own_biases(const Look& common, const model::Model& model) {
    const bool differ = common.next.addition && biases_differ(*common.next.addition->model, runs());
    if (!differ && !finds_no_name(common)) return std::nullopt;
    judge_.share_bias(series::BiasOf::power_on);
    Look own = once(model, Wanted::next_step);
    own.next.only_with_own_biases =
        own.next.addition &&
        (differ || !common.next.addition || biases_differ(*own.next.addition->model, runs()));
    if (own.next.only_with_own_biases) return own;
    judge_.share_bias(series::BiasOf::recording);
    return std::nullopt;
  }

  // A bias for each recording hides what differs between recordings alone: what the gyro does with
  // a temperature of which each has one. With one bias for all it shows; biases of power-ons do
  // too, but they do not follow an effect from one recording to another that it was not fitted to.
  std::optional<Look> between_recordings(const model::Model& model) {
    const series::BiasOf before = judge_.bias_of();
    judge_.share_bias(series::BiasOf::all);
    Look look = once(model, Wanted::next_step);
    look.next.only_between_recordings = look.next.addition.has_value();
    judge_.share_bias(look.next.addition ? series::BiasOf::recording : before);
    if (look.next.addition) return look;
    return std::nullopt;
  }

  const DiagnosisData& data_;
  std::optional<DiagnosisData> cut_;  // instead of `data_`, once a run is cut
  DiagnosisSettings settings_;
  AdditionJudge judge_;
};

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

std::vector<recording::Cut> Ladder::cuts() const {
  std::vector<recording::Cut> all = holdout_cuts;
  for (const Step& step : steps) {
    const std::vector<recording::Cut>& own = step.addition.request.cuts;
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

namespace {

Ladder ladder_of(const model::Model& model, const DiagnosisData& data, const runs::Runs& runs,
                 int max_steps, const DiagnosisSettings& settings) {
  int added = 0;
  double shown = 0;  // a refinement takes the time of a step and is none
  DiagnosisSettings each = settings;
  each.progress = [&](double part) {
    shown = std::max(shown, (added + part) / (max_steps + 1.0));
    if (settings.progress) settings.progress(shown);
  };
  Ladder ladder;
  ladder.model = model;
  Looks looks(model, data, runs, each);
  Look look = looks.at(model, Wanted::next_step);
  ladder.first = std::move(look.diagnosis);
  ladder.next = std::move(look.next);
  ladder.last = ladder.first;
  ladder.last_next = ladder.next;
  while (max_steps > 0 && ladder.last_next.addition) {
    ladder.steps.push_back(step_of(ladder.last_next, ladder.last));
    const TriedAddition& addition = ladder.steps.back().addition;
    const bool is_network = addition.request.is_network();
    if (!addition.request.refines) ++added;
    if (!addition.request.cuts.empty()) looks.cut(addition.request.cuts);
    ladder.model = with_network(ladder.model, addition, looks.runs());
    ladder.is_cut_off = !is_network && added == max_steps;
    look = looks.at(ladder.model, is_network          ? Wanted::diagnosis
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

// A jump that a diagnosis of this run alone names; nothing if it is too short for one.
std::optional<recording::Cut> jump_in(const runs::Run& run, const model::Model& model,
                                      const DiagnosisSettings& settings) {
  try {
    const DiagnosisData data(model, {run}, {});
    const Diagnosis alone = diagnose(model, data.with_bias_of(series::BiasOf::power_on), settings);
    const CandidateFinding* const step = alone.find(kBiasStep);
    if (step == nullptr || step->probability < rules::kNamed || !step->cut) return std::nullopt;
    const std::optional<std::uint64_t>& recording = step->term().recording;
    return recording::Cut{recording ? data.known().file_with(*recording) : run.file,
                          step->cut->at_s};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

std::vector<recording::Cut> jumps_in(const runs::Run& holdout, const model::Model& model,
                                     const DiagnosisSettings& settings) {
  runs::Runs cut_so_far;
  cut_so_far.holdouts = {holdout};
  std::vector<recording::Cut> cuts;
  std::set<double> at_s;
  for (;;) {
    const auto cut = jump_in(cut_so_far.holdouts[0], model, settings);
    if (!cut || !at_s.insert(cut->at_s).second) return cuts;
    cuts.push_back(*cut);
    cut_so_far = cut_so_far.with({*cut});
  }
}

}  // namespace

Ladder stepwise_selection(const model::Model& model, const DiagnosisData& data,
                          const runs::Runs& runs, int max_steps,
                          const DiagnosisSettings& settings) {
  Ladder ladder = ladder_of(model, data, runs, max_steps, settings);
  if (ladder.next.refused.empty() && ladder.last_next.refused.empty()) return ladder;
  model::Model in_rows = model;
  in_rows.average_s = data.series().rows().row_s;
  DiagnosisSettings unheard = settings;
  unheard.progress = nullptr;
  std::vector<recording::Cut> cuts;
  for (const runs::Run& holdout : runs.holdouts) {
    const std::vector<recording::Cut> own = jumps_in(holdout, in_rows, unheard);
    cuts.insert(cuts.end(), own.begin(), own.end());
  }
  if (cuts.empty()) return ladder;
  ladder = ladder_of(model, data, runs.with(cuts), max_steps, settings);
  ladder.holdout_cuts = cuts;
  return ladder;
}

}  // namespace fogcomp::diagnosis
