#include "diagnosis/addition_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/forms.hpp"
#include "fit/decision_rules.hpp"
#include "fit/effect_change.hpp"
#include "fit/possible_gain.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

double square(double value) {
  return value * value;
}

fit::EffectChange change_of(const AdditionRequest& request, const model::Model& model) {
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

// Whether the entry added something to the model; an event only masks rows.
bool is_addition(const model::HistoryEntry& entry) {
  const auto did = [&](const std::string& what) { return entry.action.rfind(what, 0) == 0; };
  const auto is_event = [&](const model::CatalogueEntry& effect) {
    return effect.description.event && did(std::string("add ") + effect.description.name);
  };
  const auto& catalogue = model::catalogue();
  return did("add ") && std::none_of(catalogue.begin(), catalogue.end(), is_event);
}

// What additions have taken out since the model's fit, (deg/h)^2. A difference of squares in one
// kind of rows: white noise cancels, so that it can be compared with one in others.
double removed_since_fit(const model::Model& model) {
  const auto first = std::find_if(model.history.begin(), model.history.end(), is_addition);
  if (first == model.history.end()) return 0;
  return square(first->rms_before_dph) - square(model.residual_rms_dph);
}

// Reason not to propose an addition that helps out of sample; "" if there is none.
std::string objection_to(const model::Model& model, const fit::Addition& addition,
                         bool may_be_little) {
  const double before_dph = addition.fitted_before_dph;
  const double after_dph = addition.fitted_after_dph;
  if (after_dph >= before_dph) return "it does not lower the error of these runs";
  if (may_be_little || is_worth_adding(model, before_dph, after_dph)) return "";
  return "its gain is so small that it may only correct inexact terms of the model: let a run "
         "that was not fitted decide, with --holdout";
}

// Refuses the trial unless it already is, or there is no objection.
void object(std::string objection, TriedAddition& trial) {
  if (objection.empty() || !trial.accepted) return;
  trial.accepted = false;
  trial.reason = std::move(objection);
}

}  // namespace

std::vector<std::string> AdditionRequest::names() const {
  std::vector<std::string> names;
  for (const std::string& effect : effects) names.push_back(effect.substr(0, effect.find(':')));
  if (!expression.empty()) names.push_back(expression.substr(0, expression.find(' ')));
  return names;
}

bool AdditionRequest::is_network() const {
  return names() == std::vector<std::string>{fit::kNetworkName};
}

fit::Addition try_to_add(const model::Model& model, const AdditionRequest& request,
                         const runs::Runs& runs) {
  return fit::add_effect(model, change_of(request, model), runs, settings_of(request));
}

bool is_worth_adding(const model::Model& model, double before_dph, double after_dph) {
  const double fall = square(before_dph) - square(after_dph);
  return fall >= rules::kWorthAdding * (removed_since_fit(model) + fall) ||
         after_dph <= (1 - rules::kHardlyHelps) * before_dph;
}

AdditionJudge::AdditionJudge(const model::Model& model, const runs::Runs& runs, bool run_offsets)
    : runs_(runs), bias_of_(run_offsets ? series::BiasOf::power_on : series::BiasOf::recording) {
  go_on_from(model);
}

void AdditionJudge::share_bias(series::BiasOf of) {
  bias_of_ = of;
  refitted_.reset();
  failure_.clear();
}

void AdditionJudge::go_on_from(const model::Model& model) {
  model_ = model;
  model_.network = {};
  refitted_.reset();
  failure_.clear();
}

void AdditionJudge::prepare() {
  if (refitted_ || !failure_.empty()) return;
  try {
    fit::AddSettings settings;
    settings.run_offsets = has_own_biases();
    refitted_ = fit::refitted(model_, runs_, settings, series_);
    series_ = refitted_->series;
  } catch (const InputError& error) {
    failure_ = error.what();
  }
}

TriedAddition AdditionJudge::operator()(AdditionRequest request) {
  std::optional<fit::Addition> addition;
  TriedAddition trial = tried(std::move(request), addition);
  take_model(addition, trial);
  return trial;
}

bool AdditionJudge::may_help(const AdditionRequest& request) {
  prepare();
  if (!refitted_) return false;
  const std::vector<model::EffectTerm>& before = refitted_->model.terms;
  const double gain =
      fit::possible_gain(*series_, before, fit::change_effects(before, request.effects).terms,
                         {refitted_->noise, refitted_->row_weights, has_own_biases()});
  return gain >= fit::rules::kVisible * fit::rules::kVisible;
}

TriedAddition AdditionJudge::tried(AdditionRequest request,
                                   std::optional<fit::Addition>& addition) {
  prepare();
  TriedAddition trial;
  trial.request = std::move(request);
  trial.request.run_offsets = has_own_biases();
  trial.reason = failure_;
  if (!refitted_) return trial;
  try {
    addition = judged(model_, trial.request, runs_, &*refitted_);
    const bool may_be_little = !runs_.holdouts.empty() || trial.request.may_be_little;
    const std::string objection =
        addition->accepted ? objection_to(model_, *addition, may_be_little) : "";
    trial.accepted = addition->accepted && objection.empty();
    trial.fails_far = std::any_of(addition->far.begin(), addition->far.end(),
                                  [](const auto& one) { return fit::harms(one); });
    trial.fitted_before_dph = addition->fitted_before_dph;
    trial.fitted_after_dph = addition->fitted_after_dph;
    if (addition->whole) {
      trial.holdouts = {addition->whole->rms_before_dph, addition->whole->rms_after_dph};
    }
    trial.reason = objection.empty() ? addition->reason : objection;
    if (bias_of_ == series::BiasOf::all && trial.accepted) {
      object(objection_of_biases(*addition), trial);
    }
    if (addition->out_of_sample) {
      trial.rms_before_dph = addition->out_of_sample->rms_before_dph;
      trial.rms_after_dph = addition->out_of_sample->rms_after_dph;
      trial.score = addition->out_of_sample->score;
    }
  } catch (const InputError& error) {
    trial.reason = error.what();
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
  if (chance < fit::rules::kFalseTurnOn) return "";
  return format(
      "biases that differ from power-on to power-on would look like it with a chance of "
      "%.2g",
      chance);
}

// The model's own rows may not show what those of the verdict do.
void AdditionJudge::take_model(std::optional<fit::Addition>& addition, TriedAddition& trial) const {
  if (!trial.accepted) return;
  try {
    fit::take_own_rows(model_, change_of(trial.request, model_), runs_, settings_of(trial.request),
                       *addition);
    trial.model = std::move(addition->model);
  } catch (const InputError& error) {
    trial.accepted = false;
    trial.reason = error.what();
  }
}

}  // namespace fogcomp::diagnosis
