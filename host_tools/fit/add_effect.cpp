#include "fit/add_effect.hpp"

#include <algorithm>
#include <utility>

#include "fit/addition_verdict.hpp"
#include "fit/decision_rules.hpp"
#include "fit/rise_test.hpp"
#include "fit/row_length.hpp"
#include "series/required_inputs.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::fit {
namespace {

// A model without and with a change, fitted to the same rows.
struct Refits {
  std::shared_ptr<const TrainingSeries> series;
  model::Model before;
  Addition after;
};

// That of the refitted model, if `model` can be fitted to it.
std::shared_ptr<const TrainingSeries> series_for(const model::Model& model,
                                                 const TrainingRuns& training,
                                                 const RefittedModel* before) {
  if (before == nullptr) return std::make_shared<TrainingSeries>(model, training);
  for (const compare::RunInBlocks& run : training.runs) series::require_inputs(model, run.blocks);
  return before->series;
}

// Refitting the model without the change is half of the work.
void fit_both(int network_hidden, const AddSettings& settings, Refits& refits) {
  FitSettings fitting = fit_settings(refits.before, settings);
  double half = 0;
  fitting.network.training.go_on = [&](double done) {
    if (settings.progress) settings.progress((half + done) / 2);
    return true;
  };
  if (settings.before != nullptr) {
    refits.before = settings.before->model;
  } else {
    fit_model(refits.before, refits.series->known(), fitting);
  }
  half = 1;
  if (network_hidden > 0) fitting.network.hidden = network_hidden;
  refits.after.fit = fit_model(refits.after.model, refits.series->known(), fitting);
}

// Rms of runs before and after, in the models' rows.
struct RunErrors {
  RiseTest training;
  RiseTest holdouts;
  std::vector<Addition::RunError> each;  // training runs, then holdouts
};

using Runs = std::vector<compare::RunInBlocks>;

RunErrors compare_on_runs(const Refits& models, const Runs& training, const Runs& holdouts,
                          bool run_offsets) {
  RunErrors errors{RiseTest(run_offsets), RiseTest(run_offsets), {}};
  const auto compare = [&](const compare::RunInBlocks& run, RiseTest& together) {
    compare::Comparison without = compare::compare_in_own_rows(models.before, run);
    compare::Comparison with = compare::compare_in_own_rows(models.after.model, run);
    together.add(without, with);
    errors.each.push_back({run.file, &together == &errors.holdouts, without.whole.rms_dph,
                           with.whole.rms_dph, run.noise_floor_dph, with.outside.temperature,
                           std::move(without), std::move(with)});
  };
  for (const compare::RunInBlocks& run : training) compare(run, errors.training);
  for (const compare::RunInBlocks& run : holdouts) compare(run, errors.holdouts);
  return errors;
}

// Errors in rows of another length, which both models then have.
RunErrors in_other_rows(double row_s, const Runs& training, const Runs& holdouts, bool run_offsets,
                        Refits& models) {
  models.before.average_s = row_s;
  models.after.model.average_s = row_s;
  RunErrors errors = compare_on_runs(models, training, holdouts, run_offsets);
  models.before.residual_rms_dph = errors.training.rms_dph().rms_before_dph;
  models.after.model.residual_rms_dph = errors.training.rms_dph().rms_after_dph;
  return errors;
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

bool is_event(const EffectChange& change) {
  return !change.changed.empty() && searches_steps({change.terms[change.changed.front()]});
}

// Both models, fitted to the runs.
Refits refit(model::Model model, const EffectChange& change, const TrainingRuns& training,
             const AddSettings& settings) {
  model.noise_dph_rthz = training.noise_dph_rthz;
  Refits refits{nullptr, model, {}};
  refits.after.model = std::move(model);
  refits.after.model.terms = change.terms;
  refits.series = series_for(refits.after.model, training, settings.before);
  fit_both(change.network_hidden, settings, refits);
  refits.after.changed =
      is_event(change)
          ? places_of_steps(change.terms[change.changed.front()].name, refits.before, refits.after)
          : places_of(change, change.changed, refits.after.model);
  return refits;
}

void accept_steps(Addition& after) {
  std::vector<std::string> places;
  for (const FoundStep& step : after.fit.identified.steps) {
    places.push_back(format("%+.2g deg/h at %.6g s", step.size_dph, step.time_s));
  }
  after.accepted = true;
  after.reason = "found " + join(places, ", ") + "; the rows around are masked";
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

RefittedModel refitted(const model::Model& model, const TrainingRuns& training,
                       const AddSettings& settings, std::shared_ptr<const TrainingSeries> series) {
  RefittedModel result{std::move(series),
                       in_rows(model, row_length(training.runs, model.average_s).row_s)};
  if (!result.series) result.series = std::make_shared<TrainingSeries>(result.model, training);
  result.model.noise_dph_rthz = training.noise_dph_rthz;
  FitResult fit =
      fit_model(result.model, result.series->known(), fit_settings(result.model, settings));
  result.noise = fit.identified.noise;
  result.row_weights = std::move(fit.identified.row_weights);
  return result;
}

Addition add_effect(const model::Model& model, const EffectChange& change,
                    const TrainingRuns& training, const std::vector<compare::RunInBlocks>& holdouts,
                    const AddSettings& settings) {
  const double row_s = row_length(training.runs, model.average_s).row_s;
  Refits refits = refit(in_rows(model, row_s), change, training, settings);
  RunErrors errors = compare_on_runs(refits, settings.verdict_only ? Runs() : training.runs,
                                     holdouts, settings.run_offsets);
  Addition& after = refits.after;
  after.row_s = row_s;
  after.fitted_before_dph = refits.before.residual_rms_dph;
  after.fitted_after_dph = after.model.residual_rms_dph;
  if (!holdouts.empty()) after.holdouts = errors.holdouts.rms_dph();
  if (is_event(change)) {
    accept_steps(after);
  } else {
    const FittedPair pair{model.terms,   change,   refits.series->known(),
                          refits.before, holdouts, settings};
    change.network_hidden > 0 ? judge_network(pair, after) : judge_effects(pair, after);
    decide(refits.before, !holdouts.empty() && errors.holdouts.rose(), after);
  }
  if (row_s != model.average_s) {
    errors = in_other_rows(model.average_s, training.runs, holdouts, settings.run_offsets, refits);
  }
  model::HistoryEntry step{"add " + change.what, training.data_hash, refits.before.residual_rms_dph,
                           after.model.residual_rms_dph, training.noise_floor_dph};
  if (!holdouts.empty()) step.holdout = errors.holdouts.rms_dph();
  step.forced = !after.accepted;
  after.model.history.push_back(std::move(step));
  after.runs = std::move(errors.each);
  return std::move(after);
}

}  // namespace fogcomp::fit
