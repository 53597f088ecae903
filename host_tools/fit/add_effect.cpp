#include "fit/add_effect.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

#include "fit/decision_rules.hpp"
#include "fit/rise_test.hpp"
#include "fit/walk_instead.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"
#include "series/required_inputs.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::fit {
namespace {

FitSettings fit_settings(const model::Model& model, const AddSettings& settings) {
  FitSettings fit;
  if (model.network.present()) fit.network_inputs = model.network.inputs;
  fit.identify.run_offsets = settings.run_offsets;
  fit.identify.max_new_steps = 1;  // one at a time: without it further steps may look larger
  fit.network.hidden = static_cast<int>(model.network.hidden.biases.size());
  fit.network.training.seed = settings.seed;
  return fit;
}

// Position of an effect after a fit, which moves the steps behind all other terms.
std::size_t place_of(const std::string& name, const std::vector<model::EffectTerm>& terms) {
  const auto found = std::find_if(terms.begin(), terms.end(),
                                  [&](const model::EffectTerm& term) { return term.name == name; });
  return static_cast<std::size_t>(found - terms.begin());
}

model::Model without_network(model::Model model) {
  model.network = {};
  return model;
}

// Data needed to compare two models out of sample.
struct Judge {
  const KnownRegressors& known;
  const std::vector<compare::RunInBlocks>& holdouts;
  JudgedWith with;

  // `changed`: the terms of `after` that `before` lacks.
  OutOfSample operator()(const model::Model& before, const model::Model& after,
                         const std::vector<std::size_t>& changed) const {
    if (holdouts.empty()) {
      return cross_validate(known, before.terms, after.terms, changed, with);
    }
    return judge_on_holdouts(without_network(before), without_network(after), holdouts, with.noise,
                             with.run_offsets);
  }
};

// The model with any subset of the added effects, refitted, each subset once; without a network.
class PartsOfSet {
 public:
  /// `given`: the terms that were changed; a fit may move steps elsewhere.
  PartsOfSet(const std::vector<model::EffectTerm>& given, const model::Model& before,
             const model::Model& after, const EffectChange& change, const KnownRegressors& known,
             const AddSettings& settings)
      : given_(given), change_(change), known_(known), settings_(settings) {
    take({}, before);
    take(change.changed, after);
  }
  // Throws InputError if the data do not determine that subset.
  const model::Model& fitted(const std::vector<std::size_t>& chosen) {
    const auto known = fitted_.find(chosen);
    if (known != fitted_.end()) return known->second;
    model::Model model = fitted_.at({});
    model.terms = given_;
    for (const std::size_t i : chosen) {
      const model::EffectTerm& term = change_.terms[i];
      if (i < model.terms.size()) {
        model.terms[i] = term;
      } else {
        model.terms.push_back(term);
      }
    }
    FitSettings fitting = fit_settings(model, settings_);
    fit_model(model, known_, fitting);
    return fitted_[chosen] = std::move(model);
  }

 private:
  void take(const std::vector<std::size_t>& chosen, const model::Model& model) {
    fitted_[chosen] = model;
    fitted_[chosen].network = {};
  }

  const std::vector<model::EffectTerm>& given_;
  const EffectChange& change_;
  const KnownRegressors& known_;
  const AddSettings& settings_;
  std::map<std::vector<std::size_t>, model::Model> fitted_;
};

// Positions in `after` of a named effect.
std::vector<std::size_t> places_of(const EffectChange& change,
                                   const std::vector<std::size_t>& chosen,
                                   const model::Model& model) {
  std::vector<std::size_t> places;
  for (const std::size_t i : chosen) places.push_back(place_of(change.terms[i].name, model.terms));
  return places;
}

// Judges the effects `added` to those of `before`; nothing if the data determine them only together
// with others.
std::optional<OutOfSample> judge_part(const EffectChange& change,
                                      const std::vector<std::size_t>& before,
                                      const std::vector<std::size_t>& after, std::size_t added,
                                      const Judge& judge, PartsOfSet& models) {
  try {
    const model::Model& with = models.fitted(after);
    return judge(models.fitted(before), with, places_of(change, {added}, with));
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool is_needless(const Addition::Part& part) {
  return part.beside && !part.beside->helps();
}

// Judges each effect of a set alone and beside the others. If only the verdict is wanted, only
// beside the others, up to the first that is not needed.
std::vector<Addition::Part> judge_parts(const EffectChange& change, const Judge& judge,
                                        PartsOfSet& models, bool verdict_only) {
  std::vector<Addition::Part> parts;
  for (const std::size_t i : change.changed) {
    Addition::Part part{change.terms[i].name, {}, {}};
    std::vector<std::size_t> others = change.changed;
    others.erase(std::find(others.begin(), others.end(), i));
    if (!verdict_only) part.alone = judge_part(change, {}, {i}, i, judge, models);
    part.beside = judge_part(change, others, change.changed, i, judge, models);
    parts.push_back(std::move(part));
    if (verdict_only && is_needless(parts.back())) break;
  }
  return parts;
}

// Judges the effects alone, on data that were not fitted.
void judge_out_of_sample(const std::vector<model::EffectTerm>& given, const model::Model& before,
                         const EffectChange& change, const KnownRegressors& known,
                         const std::vector<compare::RunInBlocks>& holdouts,
                         const AddSettings& settings, Addition& result) {
  const Identification& identified = result.fit.identified;
  const Judge judge{
      known, holdouts, {identified.noise, identified.row_weights, settings.run_offsets}};
  result.changed = places_of(change, change.changed, result.model);
  std::optional<double> chance_of_walk;
  const auto ask_walk = [&] {
    if (!identified.noise.from_quiet_parts) return;
    chance_of_walk =
        chance_of_walk_instead(before.terms, result.model.terms, result.changed, known, judge.with);
  };
  // Few runs are judged by their stretches, and then a walk is asked for: both at once.
  const bool few = holdouts.empty() && known.series().rows().runs().size() < rules::kEnoughRuns;
  std::atomic<bool> has_failed{false};
  for_each_index(few ? 2 : 1, [&](std::size_t i) {
    if (i == 1 && !has_failed) ask_walk();
    if (i == 1) return;
    result.out_of_sample = judge(before, result.model, result.changed);
    has_failed = settings.verdict_only && !result.out_of_sample->helps();
  });
  if (has_failed) return;
  if (change.changed.size() > 1) {
    PartsOfSet models(given, before, result.model, change, known, settings);
    result.parts = judge_parts(change, judge, models, settings.verdict_only);
  }
  if (!settings.verdict_only) {
    result.halves =
        judge_halves(known, before.terms, result.model.terms, result.changed, judge.with);
  }
  if (!result.out_of_sample->within_runs) return;
  if (!few) ask_walk();
  result.chance_of_walk = chance_of_walk;
}

// Compares with the same effects without the network: on the holdouts or, without any, by
// cross-validation. A network that does not help is not kept.
void judge_network(const std::vector<compare::RunInBlocks>& holdouts, bool run_offsets,
                   Addition& result) {
  result.out_of_sample = result.fit.network_judged;
  if (!result.model.network.present() || holdouts.empty()) return;
  result.out_of_sample = judge_on_holdouts(without_network(result.model), result.model, holdouts,
                                           result.fit.identified.noise, run_offsets);
}

// Reason not to accept a new part of a term although it helps.
struct Doubt {
  std::string sentence;  // "" if there is none
  bool may_be_line = false;
};
Doubt doubt_of(const model::EffectTerm& term, const model::Model& before) {
  const model::EffectTerm* own = before.find(term.name);
  for (const model::ShapeDoubt& doubt : model::shape_doubts(term)) {
    if (own != nullptr && own->identified[doubt.parameter]) continue;
    return {doubt.sentence, doubt.instead == model::kLineInTime};
  }
  // With a free shape the coefficient may be uncertain although the curve is known well: for t <<
  // t0 the logarithm of aging is a line with the slope coefficient / t0.
  const bool judged = own == nullptr && model::shape_parameters({term}).empty();
  return {judged ? model::coefficient_doubt(term) : ""};
}

// That of the refitted model, if `model` can be fitted to it.
std::shared_ptr<const TrainingSeries> series_for(const model::Model& model,
                                                 const TrainingRuns& training,
                                                 const AddSettings& settings) {
  if (settings.before == nullptr) return std::make_shared<TrainingSeries>(model, training);
  for (const compare::RunInBlocks& run : training.runs) series::require_inputs(model, run.blocks);
  return settings.before->series;
}

// Refitting the model without the change is half of the work.
void refit_both(model::Model& before, Addition& after, int network_hidden,
                const KnownRegressors& known, const AddSettings& settings) {
  FitSettings fitting = fit_settings(before, settings);
  double half = 0;
  fitting.network.training.go_on = [&](double done) {
    if (settings.progress) settings.progress((half + done) / 2);
    return true;
  };
  if (settings.before != nullptr) {
    before = settings.before->model;
  } else {
    fit_model(before, known, fitting);
  }
  half = 1;
  if (network_hidden > 0) fitting.network.hidden = network_hidden;
  after.fit = fit_model(after.model, known, fitting);
}

// Errors on all runs, the holdouts last; returns the change on the holdouts.
RiseTest compare_on_runs(const model::Model& before,
                         const std::vector<compare::RunInBlocks>& training,
                         const std::vector<compare::RunInBlocks>& holdouts,
                         const AddSettings& settings, Addition& after) {
  RiseTest on_holdouts(settings.run_offsets);
  const auto compare = [&](const compare::RunInBlocks& run, bool holdout) {
    compare::Comparison without = compare::compare_with(before, run);
    compare::Comparison with = compare::compare_with(after.model, run);
    if (holdout) on_holdouts.add(without, with);
    after.runs.push_back({run.file, holdout, without.whole.rms_dph, with.whole.rms_dph,
                          run.noise_floor_dph, with.outside.temperature, std::move(without),
                          std::move(with)});
  };
  if (!settings.verdict_only) {
    for (const compare::RunInBlocks& run : training) compare(run, false);
  }
  for (const compare::RunInBlocks& run : holdouts) compare(run, true);
  return on_holdouts;
}

// Every fit searches for steps anew and moves them behind all other terms. Accepts one more than
// `before` had.
void accept_steps(const std::string& name, const model::Model& before, Addition& result) {
  const std::vector<FoundStep>& steps = result.fit.identified.steps;
  const auto has_name = [&](const model::EffectTerm& term) { return term.name == name; };
  const auto known = std::count_if(before.terms.begin(), before.terms.end(), has_name);
  if (steps.size() <= static_cast<std::size_t>(known)) {
    throw InputError(name,
                     format("is not found: no jump of these recordings stands out of their noise "
                            "and of drift over %.3g h; a smaller one cannot be masked",
                            rules::kSlowSeconds / kSecondsPerHour));
  }
  result.changed.clear();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    result.changed.push_back(result.model.terms.size() - steps.size() + i);
  }
  std::vector<std::string> places;
  for (const FoundStep& step : steps) {
    places.push_back(format("%+.2g deg/h at %.6g s", step.size_dph, step.time_s));
  }
  result.accepted = true;
  result.reason = "found " + join(places, ", ") + "; the rows around are masked";
}

// Sets verdict and reason. `risen`: the whole model became worse on the holdouts.
void decide(const model::Model& model, const std::optional<model::HistoryEntry::Holdout>& risen,
            Addition& result) {
  result.accepted = false;
  result.reason = "its training was interrupted";
  if (!result.out_of_sample) return;
  const OutOfSample& judged = *result.out_of_sample;
  result.reason =
      format("%s out of sample: %s %s", judged.helps() ? "helps" : "does not help",
             result.changed.empty() ? "it takes the residual" : "the effects alone leave",
             out_of_sample_words(judged).c_str());
  if (!judged.helps()) return;
  Doubt doubt;
  for (const std::size_t i : result.changed) {
    if (doubt.sentence.empty()) doubt = doubt_of(result.model.terms[i], model);
  }
  const auto needless = std::find_if(result.parts.begin(), result.parts.end(), is_needless);
  if (risen) {
    result.reason =
        format("makes the whole model worse on the holdouts: %s -> %s deg/h",
               rounded(risen->rms_before_dph).c_str(), rounded(risen->rms_after_dph).c_str());
  } else if (!doubt.sentence.empty()) {
    result.reason = doubt.sentence;
    result.may_be_line = doubt.may_be_line;
  } else if (result.model.uncertain && !model.uncertain) {
    result.reason = format(
        "with it these runs do not determine the drift: in a soak it is known to +- %.2g "
        "deg/h, and %.2g deg/h are to be compensated",
        result.model.uncertain->sigma_dph, result.model.uncertain->drift_dph);
  } else if (needless != result.parts.end()) {
    result.reason = needless->effect +
                    " brings nothing beside the others: " + out_of_sample_words(*needless->beside);
  } else if (result.chance_of_walk.value_or(0) >= rules::kMaxChanceOfWalk) {
    result.reason =
        "on these runs alone a random walk of the bias explains it as well: let a run that was not "
        "fitted decide, with --holdout";
  } else {
    result.accepted = true;
  }
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
  if (series == nullptr) series = std::make_shared<TrainingSeries>(model, training);
  RefittedModel result{std::move(series), model};
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
  Addition result;
  model::Model before = model;
  before.noise_dph_rthz = training.noise_dph_rthz;
  result.model = before;
  result.model.terms = change.terms;
  const std::shared_ptr<const TrainingSeries> series = series_for(result.model, training, settings);
  refit_both(before, result, change.network_hidden, series->known(), settings);
  const bool is_event =
      !change.changed.empty() && searches_steps({change.terms[change.changed.front()]});
  if (is_event) {
    accept_steps(change.terms[change.changed.front()].name, before, result);
  } else if (change.network_hidden > 0) {
    judge_network(holdouts, settings.run_offsets, result);
  } else {
    judge_out_of_sample(model.terms, before, change, series->known(), holdouts, settings, result);
  }
  const RiseTest on_holdouts = compare_on_runs(before, training.runs, holdouts, settings, result);
  model::HistoryEntry step{"add " + change.what, training.data_hash, before.residual_rms_dph,
                           result.model.residual_rms_dph, training.noise_floor_dph};
  if (!holdouts.empty()) step.holdout = on_holdouts.rms_dph();
  const bool rose = !holdouts.empty() && on_holdouts.rose();
  if (!is_event) decide(model, rose ? step.holdout : std::nullopt, result);
  step.forced = !result.accepted;
  result.model.history.push_back(step);
  return result;
}

}  // namespace fogcomp::fit
