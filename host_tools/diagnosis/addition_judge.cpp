#include "diagnosis/addition_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/forms.hpp"
#include "fit/effect_change.hpp"
#include "fit/shape_search.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "support/evidence.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

fit::EffectChange change_of(const AdditionRequest& request, const model::Model& model) {
  if (!request.cuts.empty()) return fit::change_cuts(model.terms, request.cuts);
  return request.expression.empty() ? fit::change_effects(model.terms, request.effects)
                                    : fit::change_expression(model.terms, request.expression);
}

fit::AddSettings settings_of(const AdditionRequest& request,
                             const fit::RefittedModel* before = nullptr) {
  fit::AddSettings settings;
  settings.run_offsets = request.run_offsets;
  settings.verdict_only = true;
  settings.before = before;
  return settings;
}

fit::Addition judged(const model::Model& model, const AdditionRequest& request,
                     const runs::Runs& runs, const fit::RefittedModel* before = nullptr) {
  return fit::judge_addition(model, change_of(request, model), runs, settings_of(request, before));
}

}  // namespace

std::vector<std::string> AdditionRequest::names() const {
  std::vector<std::string> names;
  for (const std::string& effect : effects) names.push_back(effect.substr(0, effect.find(':')));
  if (!expression.empty()) names.push_back(expression.substr(0, expression.find(' ')));
  if (!cuts.empty()) names.emplace_back(kBiasStep);
  return names;
}

bool AdditionRequest::is_network() const {
  return names() == std::vector<std::string>{fit::kNetworkName};
}

fit::Addition try_to_add(const model::Model& model, const AdditionRequest& request,
                         const runs::Runs& runs) {
  return fit::add_effect(model, change_of(request, model), runs, settings_of(request));
}

AdditionJudge::AdditionJudge(const model::Model& model, const runs::Runs& runs, bool run_offsets)
    : runs_(&runs), bias_of_(run_offsets ? series::BiasOf::power_on : series::BiasOf::recording) {
  go_on_from(model);
}

void AdditionJudge::share_bias(series::BiasOf of) {
  bias_of_ = of;
  forget();
}

void AdditionJudge::go_on_with(runs::Runs runs) {
  cut_runs_ = std::move(runs);
  runs_ = &*cut_runs_;
  series_.reset();
  forget();
}

void AdditionJudge::go_on_from(const model::Model& model) {
  model_ = model;
  model_.network = {};
  forget();
}

void AdditionJudge::forget() {
  refitted_.reset();
  failure_.clear();
}

void AdditionJudge::prepare() const {
  if (refitted_ || !failure_.empty()) return;
  try {
    fit::AddSettings settings;
    settings.run_offsets = has_own_biases();
    refitted_ = fit::refitted(model_, *runs_, settings, series_);
    series_ = refitted_->series;
  } catch (const InputError& error) {
    failure_ = error.what();
  }
}

TriedAddition AdditionJudge::operator()(AdditionRequest request) const {
  prepare();
  TriedAddition trial;
  trial.request = std::move(request);
  trial.request.run_offsets = has_own_biases();
  trial.reason = failure_;
  if (!refitted_) return trial;
  std::optional<runs::Runs> cut;
  if (!trial.request.cuts.empty()) cut = runs_->with(trial.request.cuts);
  const runs::Runs& runs = cut ? *cut : *runs_;
  try {
    fit::Addition addition = judged(model_, trial.request, runs, &*refitted_);
    trial = verdict_of(addition, std::move(trial));
    if (!trial.accepted) return trial;
    // The model's own rows may not show what those of the verdict do.
    fit::take_own_rows(model_, change_of(trial.request, model_), runs, settings_of(trial.request),
                       addition);
    trial.model = std::move(addition.model);
  } catch (const InputError& error) {
    trial.accepted = false;
    trial.reason = error.what();
  }
  return trial;
}

bool AdditionJudge::may_help(const AdditionRequest& request) const {
  prepare();
  if (!refitted_) return false;
  const std::vector<model::EffectTerm>& before = refitted_->model.terms;
  const double gain =
      fit::possible_gain(*series_, before, fit::change_effects(before, request.effects).terms,
                         {refitted_->noise, refitted_->row_weights, has_own_biases()});
  return gain >= kCertainSigmas * kCertainSigmas;
}

TriedAddition AdditionJudge::verdict_of(const fit::Addition& addition, TriedAddition trial) const {
  trial.accepted = addition.accepted;
  trial.reason = addition.reason;
  trial.needless = addition.needless;
  trial.fitted_before_dph = addition.fitted_before_dph;
  trial.fitted_after_dph = addition.fitted_after_dph;
  if (addition.whole) {
    trial.holdouts = {addition.whole->rms_before_dph, addition.whole->rms_after_dph};
  }
  if (bias_of_ == series::BiasOf::all && trial.accepted) {
    const std::string objection = objection_of_biases(addition);
    trial.accepted = objection.empty();
    if (!trial.accepted) trial.reason = objection;
  }
  if (addition.out_of_sample) {
    trial.rms_before_dph = addition.out_of_sample->rms_before_dph;
    trial.rms_after_dph = addition.out_of_sample->rms_after_dph;
    trial.score = addition.out_of_sample->score;
  }
  return trial;
}

// Reason why what differs between recordings may as well be their biases; "" if it may not.
std::string AdditionJudge::objection_of_biases(const fit::Addition& addition) const {
  if (!addition.out_of_sample || addition.out_of_sample->within_runs) {
    return "what differs between recordings alone needs another to judge it";
  }
  const double chance =
      fit::chance_of_biases(*series_, refitted_->model.terms, addition.model.terms,
                            {refitted_->noise, refitted_->row_weights, false});
  if (chance < kFalseAlarm) return "";
  return format(
      "biases that differ from power-on to power-on would look like it with a chance of "
      "%.2g",
      chance);
}

}  // namespace fogcomp::diagnosis
