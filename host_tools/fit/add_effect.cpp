#include "fit/add_effect.hpp"

#include <algorithm>
#include <utility>

#include "fit/addition_verdict.hpp"
#include "runs/row_length.hpp"
#include "series/required_inputs.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// A model without and with a change, fitted in rows of its average_s.
struct Refits {
  std::shared_ptr<const KnownRegressors> series;
  model::Model before;
  Addition after;
};

// That of the refitted model, if `model` can be fitted to it.
std::shared_ptr<const KnownRegressors> series_for(const model::Model& model,
                                                  const std::vector<runs::Run>& training,
                                                  const RefittedModel* before) {
  if (before == nullptr) return std::make_shared<KnownRegressors>(model, training);
  for (const runs::Run& run : training) series::require_inputs(model, run.blocks);
  return before->series;
}

// Bias steps that are known before a fit.
struct KnownSteps {
  std::vector<FoundStep> before;
  std::vector<FoundStep> after;
};

// Refitting the model without the change is half of the work. `steps`: nullptr if they are to be
// searched for.
void fit_both(int network_hidden, const AddSettings& settings, const KnownSteps* steps,
              Refits& refits) {
  FitSettings fitting = fit_settings(refits.before, settings);
  if (steps != nullptr) fitting.identify.steps = steps->before;
  double half = 0;
  fitting.network.training.go_on = [&](double done) {
    if (settings.progress) settings.progress((half + done) / 2);
    return true;
  };
  if (settings.before != nullptr) {
    refits.before = settings.before->model;
  } else {
    fit_model(refits.before, *refits.series, fitting);
  }
  half = 1;
  if (steps != nullptr) fitting.identify.steps = steps->after;
  if (network_hidden > 0) fitting.network.hidden = network_hidden;
  refits.after.fit = fit_model(refits.after.model, *refits.series, fitting);
}

// Errors on all runs, the holdouts last, in the models' rows.
void compare_on_runs(const runs::Runs& runs, const AddSettings& settings, Refits& refits) {
  const auto compare = [&](const runs::Run& run, bool holdout) {
    const double row_s = refits.before.average_s;
    compare::Comparison without = compare::compare_with(refits.before, run, row_s);
    compare::Comparison with = compare::compare_with(refits.after.model, run, row_s);
    refits.after.runs.push_back({run.file, holdout, without.whole.rms_dph, with.whole.rms_dph,
                                 without.noise_floor_dph, with.outside.temperature,
                                 std::move(without), std::move(with)});
  };
  if (!settings.verdict_only) {
    for (const runs::Run& run : runs.training) compare(run, false);
  }
  for (const runs::Run& run : runs.holdouts) compare(run, true);
  if (runs.holdouts.empty()) return;
  refits.after.whole = judge_on_holdouts(refits.before, refits.after.model, runs.holdouts,
                                         refits.after.fit.identified.noise, settings.run_offsets);
}

// Every fit searches for steps anew and moves them behind all other terms. Returns their places;
// there must be one more than `before` has.
std::vector<std::size_t> places_of_steps(const std::string& name, const model::Model& before,
                                         const Addition& after) {
  const std::vector<FoundStep>& steps = after.fit.identified.steps;
  const auto has_name = [&](const model::EffectTerm& term) { return term.name == name; };
  const auto known = std::count_if(before.terms.begin(), before.terms.end(), has_name);
  if (steps.size() <= static_cast<std::size_t>(known)) {
    throw InputError(name,
                     "is not found: no jump of these recordings stands out of their noise and of "
                     "changes over minutes and hours; a smaller one cannot be masked");
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    places.push_back(after.model.terms.size() - steps.size() + i);
  }
  return places;
}

// Both models, fitted to the runs.
Refits refit(model::Model model, const EffectChange& change, const runs::Runs& runs,
             const AddSettings& settings, const KnownSteps* steps = nullptr) {
  model.noise_dph_rthz = runs.noise_dph_rthz;
  Refits refits{nullptr, model, {}};
  refits.after.model = std::move(model);
  refits.after.model.terms = change.terms;
  refits.series = series_for(refits.after.model, runs.training, settings.before);
  fit_both(change.network_hidden, settings, steps, refits);
  refits.after.changed =
      is_event(change)
          ? places_of_steps(change.terms[change.changed.front()].name, refits.before, refits.after)
          : places_of(change, change.changed, refits.after.model);
  return refits;
}

// Appends the change and what it brought to the model's history.
void record(const EffectChange& change, const runs::Runs& runs, Refits& refits) {
  Addition& after = refits.after;
  model::HistoryEntry step{"add " + change.what, runs.data_hash, refits.before.residual_rms_dph,
                           after.model.residual_rms_dph,
                           runs.noise_floor_dph(after.model.average_s)};
  if (after.whole) step.holdout = {after.whole->rms_before_dph, after.whole->rms_after_dph};
  step.forced = !after.accepted;
  after.model.history.push_back(std::move(step));
}

// The steps of a model in these runs.
std::vector<FoundStep> steps_of(const model::Model& model, const std::vector<runs::Run>& training) {
  std::vector<FoundStep> steps;
  for (const model::EffectTerm& term : model.terms) {
    if (!searches_steps({term})) continue;
    for (std::size_t run = 0; run < training.size(); ++run) {
      if (training[run].blocks.recordings.front() != term.recording) continue;
      const model::Parameter& time_s = term.parameters[0];
      steps.push_back({run, time_s.value, time_s.sigma, 0, 0, term.others_part});
    }
  }
  return steps;
}

model::Model in_rows(const model::Model& model, double row_s) {
  model::Model result = model;
  result.average_s = row_s;
  return result;
}

}  // namespace

std::vector<std::string> Addition::names() const {
  if (changed.empty()) return {kNetworkName};
  std::vector<std::string> names;
  for (const std::size_t i : changed) names.push_back(model.terms[i].name);
  return names;
}

RefittedModel refitted(const model::Model& model, const runs::Runs& runs,
                       const AddSettings& settings, std::shared_ptr<const KnownRegressors> series) {
  RefittedModel result{std::move(series),
                       in_rows(model, runs::row_length(runs.training, model.average_s).row_s)};
  if (!result.series)
    result.series = std::make_shared<KnownRegressors>(result.model, runs.training);
  result.model.noise_dph_rthz = runs.noise_dph_rthz;
  FitResult fit = fit_model(result.model, *result.series, fit_settings(result.model, settings));
  result.noise = fit.identified.noise;
  result.row_weights = std::move(fit.identified.row_weights);
  return result;
}

Addition judge_addition(const model::Model& model, const EffectChange& change,
                        const runs::Runs& runs, const AddSettings& settings) {
  const double row_s = runs::row_length(runs.training, model.average_s).row_s;
  Refits refits = refit(in_rows(model, row_s), change, runs, settings);
  compare_on_runs(runs, settings, refits);
  Addition& after = refits.after;
  after.row_s = row_s;
  after.fitted_before_dph = refits.before.residual_rms_dph;
  after.fitted_after_dph = after.model.residual_rms_dph;
  const FittedPair pair{model.terms, change, *refits.series, refits.before, runs, settings};
  change.network_hidden > 0 ? judge_network(pair, after) : judge_effects(pair, after);
  decide(after);
  record(change, runs, refits);
  return std::move(after);
}

void take_own_rows(const model::Model& model, const EffectChange& change, const runs::Runs& runs,
                   const AddSettings& settings, Addition& addition) {
  if (addition.row_s == model.average_s) return;
  AddSettings anew = settings;
  anew.before = nullptr;
  const KnownSteps steps{steps_of(model, runs.training), addition.fit.identified.steps};
  Refits refits = refit(model, change, runs, anew, &steps);
  static_cast<AdditionVerdict&>(refits.after) = addition;
  compare_on_runs(runs, settings, refits);
  record(change, runs, refits);
  refits.after.whole = std::move(addition.whole);
  addition = std::move(refits.after);
}

Addition add_effect(const model::Model& model, const EffectChange& change, const runs::Runs& runs,
                    const AddSettings& settings) {
  const bool has_own_rows =
      runs::row_length(runs.training, model.average_s).row_s != model.average_s;
  AddSettings half = settings;
  double begun = 0;
  half.progress = [&](double done) {
    if (settings.progress) settings.progress(has_own_rows ? (begun + done) / 2 : done);
  };
  Addition addition = judge_addition(model, change, runs, half);
  begun = 1;
  take_own_rows(model, change, runs, half, addition);
  return addition;
}

}  // namespace fogcomp::fit
