#include "diagnosis/addition_judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/forms.hpp"
#include "fit/cross_validation.hpp"
#include "fit/decision_rules.hpp"
#include "fit/effect_change.hpp"
#include "fit/possible_gain.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "model/catalogue.hpp"
#include "model/effect_list.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
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

// The same with all that the formulas of its effects of time leave out; nothing if that is nothing.
std::optional<AdditionRequest> with_all_parts(AdditionRequest request) {
  bool has_more = false;
  for (std::string& effect : request.effects) {
    const model::EffectTerm term = model::parse_effects(effect).front();
    if (!has(model::info_of(term).needs, fog::Input::elapsed)) continue;
    const std::vector<std::string> settings = model::possible_refinements(term);
    if (settings.empty()) continue;
    effect += (effect.find(':') == std::string::npos ? ":" : ",") + join(settings, ",");
    has_more = true;
  }
  return has_more ? std::optional(std::move(request)) : std::nullopt;
}

// The same formula with lags of many hours; nothing if it has none.
std::optional<AdditionRequest> with_more_room(AdditionRequest request) {
  std::string expression = with_longer_lags(request.expression);
  if (expression == request.expression) return std::nullopt;
  request.expression = std::move(expression);
  return request;
}

// Judges a request and, if a line in time would do as well, the same with all parts; if a formula's
// lag should be longer than it may, with longer ones.
template <class Judge>
TriedAddition with_second_try(AdditionRequest request, const Judge& judge) {
  TriedAddition first = judge(request);
  if (!first.may_be_line && !first.wants_more) return first;
  const auto more =
      first.may_be_line ? with_all_parts(std::move(request)) : with_more_room(std::move(request));
  if (!more) return first;
  TriedAddition second = judge(*more);
  return second.accepted ? second : first;
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
  return with_second_try(std::move(request),
                         [&](AdditionRequest one) { return as_it_is(std::move(one)); });
}

TriedAddition AdditionJudge::as_it_is(AdditionRequest request) {
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
    trial.may_be_walk = addition->chance_of_walk.value_or(0) >= fit::rules::kMaxChanceOfWalk;
    trial.may_be_line = addition->may_be_line;
    trial.wants_more = addition->wants_more;
    trial.fails_far = addition->thirds && addition->thirds->harms();
    trial.fitted_before_dph = addition->fitted_before_dph;
    trial.fitted_after_dph = addition->fitted_after_dph;
    trial.holdouts = addition->holdouts;
    trial.reason = objection.empty() ? addition->reason : objection;
    if (bias_of_ == series::BiasOf::all && trial.accepted) {
      object(objection_of_biases(*addition), trial);
    }
    if (addition->out_of_sample) {
      trial.rms_before_dph = addition->out_of_sample->rms_before_dph;
      trial.rms_after_dph = addition->out_of_sample->rms_after_dph;
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

TriedAddition AdditionJudge::of_description(AdditionRequest request) {
  return with_second_try(std::move(request),
                         [&](AdditionRequest one) { return description_as_it_is(std::move(one)); });
}

TriedAddition AdditionJudge::description_as_it_is(AdditionRequest request) {
  std::optional<fit::Addition> addition;
  TriedAddition trial = tried(std::move(request), addition);
  const std::size_t count = runs_.holdouts.empty() ? runs_.training.size() : 0;
  std::vector<std::string> objections(count < 2 || !trial.accepted ? 0 : count);
  for_each_index(objections.size(), [&](std::size_t run) {
    objections[run] = objection_of_run(trial.request, run, *addition);
  });
  for (std::string& objection : objections) object(std::move(objection), trial);
  if (trial.accepted) {
    object(objection_of_far_rows(*addition), trial);
    trial.fails_far = !trial.accepted;
  }
  take_model(addition, trial);
  return trial;
}

// Reason why the addition raises the error of rows unlike those that it was fitted to; "" if it
// does not, if the runs do not show it, or if holdouts judge. A name is not asked
// this: other effects that are missing stand out in some of these rows only.
std::string AdditionJudge::objection_of_far_rows(const fit::Addition& addition) const {
  if (!runs_.holdouts.empty() || !addition.out_of_sample || addition.changed.empty()) return "";
  const fit::Identification& fit = addition.fit.identified;
  const fit::JudgedWith with{fit.noise, fit.row_weights, has_own_biases()};
  const fit::CrossValidation validation(*series_, refitted_->model.terms, addition.model.terms,
                                        addition.changed, with);
  const auto directions = validation.on_far_rows(fit::FarRows::directions);
  if (directions && directions->harms()) return fit::harm_words(*directions);
  const fit::TemperatureTest temperatures = validation.on_temperatures();
  if (temperatures.judged && temperatures.judged->harms()) {
    return fit::harm_words(*temperatures.judged);
  }
  if (temperatures.fails()) return fit::failure_words(temperatures);
  return "";
}

// Reason why the addition, identified on the other runs, fails on this run; "" if it does not, or
// if the others do not show it.
std::string AdditionJudge::objection_of_run(const AdditionRequest& request, std::size_t run,
                                            const fit::Addition& on_all) const {
  try {
    const fit::Addition addition = judged(model_, request, runs_.without(run));
    const auto& judged = addition.out_of_sample;
    if (!judged || judged->rms_after_dph < judged->rms_before_dph) return "";
    const bool is_physics = request.expression.empty() && !request.is_network();
    if (is_physics && std::abs(judged->chi2_drop) <= fit::rules::kMaxUselessDrop) return "";
    if (!others_show(on_all, run)) return "";
    return format("it does not hold on %s when that run is left out: %s -> %s deg/h",
                  runs_.training[run].file.c_str(), rounded(judged->rms_before_dph).c_str(),
                  rounded(judged->rms_after_dph).c_str());
  } catch (const InputError&) {
    return "";
  }
}

// Whether the other runs show what the addition does with inputs of its own. Temperature and time
// move in every run: there the veto of one that goes further stands.
bool AdditionJudge::others_show(const fit::Addition& on_all, std::size_t run) const {
  std::vector<std::size_t> of_own_input;
  for (const std::size_t term : on_all.changed) {
    if (model::has_own_input(on_all.model.terms[term])) of_own_input.push_back(term);
  }
  if (of_own_input.empty()) return true;
  const fit::Identification& fit = on_all.fit.identified;
  return fit::others_determine(*series_, on_all.model.terms, of_own_input, run,
                               {fit.noise, fit.row_weights, has_own_biases()});
}

}  // namespace fogcomp::diagnosis
