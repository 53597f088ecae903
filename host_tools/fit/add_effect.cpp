#include "fit/add_effect.hpp"

#include <algorithm>
#include <utility>

#include "fit/addition_verdict.hpp"
#include "runs/run.hpp"
#include "series/signal_series.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// A model without and with a change, fitted in rows of its average_s.
struct Refits {
  std::shared_ptr<const KnownRegressors> series_before;
  std::shared_ptr<const KnownRegressors> series;
  model::Model before;
  Addition after;
};

// Of the refitted model, if there is one.
std::shared_ptr<const KnownRegressors> series_before(const model::Model& model,
                                                     const EffectChange& change,
                                                     const runs::Runs& runs,
                                                     const RefittedModel* before) {
  if (before != nullptr) return before->series;
  if (change.cuts.empty()) return std::make_shared<KnownRegressors>(model, runs.training);
  std::vector<runs::Run> uncut;
  for (const runs::Run& run : runs.training) uncut.push_back(runs::without_cuts(run, change.cuts));
  return std::make_shared<KnownRegressors>(model, uncut);
}

// The same, if the change needs no other rows and the runs have its inputs.
std::shared_ptr<const KnownRegressors> series_after(
    const model::Model& model, const EffectChange& change, const runs::Runs& runs,
    const std::shared_ptr<const KnownRegressors>& before) {
  for (const runs::Run& run : runs.training) series::require_inputs(model, run.blocks);
  if (change.cuts.empty()) return before;
  return std::make_shared<KnownRegressors>(model, runs.training);
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
    fit_model(refits.before, *refits.series_before, fitting);
  }
  half = 1;
  if (network_hidden > 0) fitting.network.hidden = network_hidden;
  refits.after.fit = fit_model(refits.after.model, *refits.series, fitting);
}

// Errors on all runs, the holdouts last, in the models' rows.
void compare_on_runs(const EffectChange& change, const runs::Runs& runs,
                     const AddSettings& settings, Refits& refits) {
  const double row_s = refits.before.average_s;
  const auto compare = [&](const runs::Run& before, const runs::Run& run, bool holdout) {
    compare::Comparison without = compare::compare_with(refits.before, before, row_s);
    compare::Comparison with = compare::compare_with(refits.after.model, run, row_s);
    refits.after.runs.push_back({run.file, holdout, without.whole.rms_dph, with.whole.rms_dph,
                                 without.noise_floor_dph, with.outside.temperature,
                                 std::move(without), std::move(with)});
  };
  for (const runs::Run& run : runs.training) {
    if (settings.verdict_only) break;
    change.cuts.empty() ? compare(run, run, false)
                        : compare(runs::without_cuts(run, change.cuts), run, false);
  }
  for (const runs::Run& run : runs.holdouts) compare(run, run, true);
  if (runs.holdouts.empty()) return;
  refits.after.whole = judge_on_holdouts(refits.before, refits.after.model, runs.holdouts,
                                         refits.after.fit.identified.noise, settings.run_offsets);
}

// Both models, fitted to the runs.
Refits refit(model::Model model, const EffectChange& change, const runs::Runs& runs,
             const AddSettings& settings) {
  model.noise_dph_rthz = runs.noise_dph_rthz;
  Refits refits{nullptr, nullptr, model, {}};
  refits.after.model = std::move(model);
  refits.after.model.terms = change.terms;
  refits.series_before = series_before(refits.after.model, change, runs, settings.before);
  refits.series = series_after(refits.after.model, change, runs, refits.series_before);
  fit_both(change.network_hidden, settings, refits);
  refits.after.changed = change.changed;
  refits.after.cuts = change.cuts;
  return refits;
}

// Appends the change and what it brought to the model's history.
void record(const EffectChange& change, const runs::Runs& runs, Refits& refits) {
  Addition& after = refits.after;
  const std::string what = (change.what.empty() ? "" : " ") + change.what + runs.read_with;
  model::HistoryEntry step{"add" + what, runs.data_hash, refits.before.residual_rms_dph,
                           after.model.residual_rms_dph,
                           runs.noise_floor_dph(after.model.average_s)};
  if (after.whole) step.holdout = {after.whole->rms_before_dph, after.whole->rms_after_dph};
  step.forced = !after.accepted;
  after.model.history.push_back(std::move(step));
}

model::Model in_rows(const model::Model& model, double row_s) {
  model::Model result = model;
  result.average_s = row_s;
  return result;
}

}  // namespace

std::vector<std::string> Addition::names() const {
  if (!cuts.empty()) return {kCutName};
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
  compare_on_runs(change, runs, settings, refits);
  Addition& after = refits.after;
  after.row_s = row_s;
  after.fitted_before_dph = refits.before.residual_rms_dph;
  after.fitted_after_dph = after.model.residual_rms_dph;
  const FittedPair pair{
      model.terms,   change, *refits.series, refits.series_before->series().rows(),
      refits.before, runs,   settings};
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
  Refits refits = refit(model, change, runs, anew);
  static_cast<AdditionVerdict&>(refits.after) = addition;
  compare_on_runs(change, runs, settings, refits);
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
