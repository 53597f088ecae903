#include "diagnosis/ladder.hpp"

#include <algorithm>

namespace fogcomp::diagnosis {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Ladder::Step step_of(const NextStep& next, const Diagnosis& before) {
  const model::HistoryEntry& entry = next.addition->model->history.back();
  Ladder::Step step{*next.addition, next.describes, {}, entry.rms_before_dph, entry.rms_after_dph};
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
  int done = 0;
  DiagnosisSettings each = settings;
  each.progress = [&](double part) {
    if (settings.progress) settings.progress((done + part) / (max_steps + 1.0));
  };
  DiagnosisSettings unheard = settings;
  unheard.progress = nullptr;
  Ladder ladder;
  ladder.model = model;
  ladder.first = diagnose(model, data, each);
  ladder.next = find_next_step(model, ladder.first, data, runs, unheard);
  if (ladder.next.refutes_name) withdraw_name(ladder.first);
  ladder.last = ladder.first;
  ladder.last_next = ladder.next;
  while (done < max_steps && ladder.last_next.addition) {
    ++done;
    ladder.steps.push_back(step_of(ladder.last_next, ladder.last));
    const TriedAddition& addition = ladder.steps.back().addition;
    const bool is_network = addition.request.is_network();
    ladder.model = with_network(ladder.model, addition, runs);
    ladder.last = diagnose(ladder.model, data, each);
    const std::vector<TriedAddition> refused = std::move(ladder.last_next.refused);
    ladder.last_next = {};
    if (is_network) {  // its effects are those with which all other additions were refused
      ladder.last_next.refused = refused;
      break;
    }
    if (done < max_steps) {
      ladder.last_next = find_next_step(ladder.model, ladder.last, data, runs, unheard);
      if (ladder.last_next.refutes_name) withdraw_name(ladder.last);
    }
  }
  return ladder;
}

}  // namespace fogcomp::diagnosis
