#include "fit/addition_verdict.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

#include "fit/decision_rules.hpp"
#include "fit/walk_instead.hpp"
#include "model/catalogue.hpp"
#include "model/shape_limits.hpp"
#include "model/shape_parameter.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

model::Model without_network(model::Model model) {
  model.network = {};
  return model;
}

// Data needed to compare two models out of sample.
struct Judge {
  const FittedPair& pair;
  JudgedWith with;

  // `changed`: the terms of `after` that `before` lacks.
  OutOfSample operator()(const model::Model& before, const model::Model& after,
                         const std::vector<std::size_t>& changed) const {
    if (!pair.holdouts.empty()) return on_holdouts(before, after);
    return CrossValidation(pair.known, before.terms, after.terms, changed, with)
        .on_runs_or_stretches();
  }
  OutOfSample on_holdouts(const model::Model& before, const model::Model& after) const {
    return judge_on_holdouts(without_network(before), without_network(after), pair.holdouts,
                             with.noise, with.run_offsets);
  }
};

// The model with subsets of the added effects, refitted; without a network.
class PartsOfSet {
 public:
  using Subset = std::vector<std::size_t>;

  PartsOfSet(const FittedPair& pair, const model::Model& after) : pair_(pair) {
    fitted_[{}] = without_network(pair.before);
    fitted_[pair.change.changed] = without_network(after);
  }
  // Fits those that are not known yet, side by side.
  void fit(const std::vector<Subset>& subsets) {
    std::vector<std::pair<const Subset, std::optional<model::Model>>*> unknown;
    for (const Subset& subset : subsets) {
      const auto [entry, is_new] = fitted_.try_emplace(subset);
      if (is_new) unknown.push_back(&*entry);
    }
    for_each_index(unknown.size(),
                   [&](std::size_t i) { unknown[i]->second = refit_with(unknown[i]->first); });
  }
  // Nothing if the data do not determine that subset; it must have been fitted.
  const std::optional<model::Model>& with(const Subset& subset) const { return fitted_.at(subset); }

 private:
  std::optional<model::Model> refit_with(const Subset& chosen) const {
    model::Model model = *fitted_.at({});
    model.terms = pair_.given;
    for (const std::size_t i : chosen) {
      const model::EffectTerm& term = pair_.change.terms[i];
      if (i < model.terms.size()) {
        model.terms[i] = term;
      } else {
        model.terms.push_back(term);
      }
    }
    try {
      fit_model(model, pair_.known, fit_settings(model, pair_.settings));
    } catch (const InputError&) {
      return std::nullopt;
    }
    return model;
  }

  const FittedPair& pair_;
  std::map<Subset, std::optional<model::Model>> fitted_;
};

// Judges the effects `added` to those of `before`; nothing if the data determine them only together
// with others.
std::optional<OutOfSample> judge_part(const Judge& judge, const PartsOfSet& models,
                                      const PartsOfSet::Subset& before,
                                      const PartsOfSet::Subset& after, std::size_t added) {
  const std::optional<model::Model>& without = models.with(before);
  const std::optional<model::Model>& with = models.with(after);
  if (!without || !with) return std::nullopt;
  return judge(*without, *with, places_of(judge.pair.change, {added}, *with));
}

bool is_needless(const Addition::Part& part) {
  return part.beside && !part.beside->helps();
}

PartsOfSet::Subset all_but(const PartsOfSet::Subset& all, std::size_t one) {
  PartsOfSet::Subset others = all;
  others.erase(std::find(others.begin(), others.end(), one));
  return others;
}

// Judges each effect of a set alone and beside the others. If only the verdict is wanted, only
// beside the others, up to the first that is not needed.
std::vector<Addition::Part> judge_parts(const Judge& judge, PartsOfSet& models) {
  const EffectChange& change = judge.pair.change;
  const PartsOfSet::Subset& all = change.changed;
  const bool verdict_only = judge.pair.settings.verdict_only;
  std::vector<PartsOfSet::Subset> subsets;
  for (const std::size_t i : all) {
    subsets.push_back(all_but(all, i));
    if (!verdict_only) subsets.push_back({i});
  }
  models.fit(subsets);
  std::vector<Addition::Part> parts(all.size());
  std::vector<std::atomic<bool>> needless(parts.size());
  for_each_index(parts.size(), [&](std::size_t i) {
    const auto own = needless.begin() + static_cast<std::ptrdiff_t>(i);
    if (verdict_only && std::find(needless.begin(), own, true) != own) return;
    parts[i].effect = change.terms[all[i]].name;
    if (!verdict_only) parts[i].alone = judge_part(judge, models, {}, {all[i]}, all[i]);
    parts[i].beside = judge_part(judge, models, all_but(all, all[i]), all, all[i]);
    *own = is_needless(parts[i]);
  });
  const auto first = std::find_if(parts.begin(), parts.end(), is_needless);
  if (verdict_only && first != parts.end()) parts.erase(first + 1, parts.end());
  return parts;
}

// Judges the effects out of sample: all together, each of several, far from the rows fitted.
void judge_rows(const Judge& judge, Addition& after) {
  const FittedPair& pair = judge.pair;
  std::optional<CrossValidation> validation;
  const bool holdouts_judge = !pair.holdouts.empty() && !is_event(pair.change);
  if (!holdouts_judge || !pair.settings.verdict_only) {
    validation.emplace(pair.known, pair.before.terms, after.model.terms, after.changed, judge.with);
  }
  after.out_of_sample = holdouts_judge ? judge.on_holdouts(pair.before, after.model)
                                       : validation->on_runs_or_stretches();
  if (pair.settings.verdict_only && !after.out_of_sample->helps()) return;
  if (pair.change.changed.size() > 1) {
    PartsOfSet models(pair, after.model);
    after.parts = judge_parts(judge, models);
  }
  if (!pair.settings.verdict_only) after.halves = validation->on_halves();
  const bool has_needless = std::any_of(after.parts.begin(), after.parts.end(), is_needless);
  if (after.out_of_sample->within_runs && after.out_of_sample->helps() && !has_needless) {
    after.thirds = validation->on_far_rows(FarRows::thirds);
  }
}

std::optional<double> ask_walk(const Judge& judge, const Addition& after) {
  if (!judge.with.noise.from_quiet_parts) return std::nullopt;
  return chance_of_walk_instead(judge.pair.before.terms, after.model.terms, after.changed,
                                judge.pair.known, judge.with);
}

// Reason not to accept a new part of a term although it helps.
struct Doubt {
  std::string sentence;  // "" if there is none
  bool may_be_line = false;
  bool wants_more = false;
};
Doubt doubt_of(const model::EffectTerm& term, const model::Model& before) {
  const model::EffectTerm* own = model::is_event(term) ? nullptr : before.find(term.name);
  for (const model::ShapeDoubt& doubt : model::shape_doubts(term)) {
    if (own != nullptr && own->parameters[doubt.parameter].identified) continue;
    // Other bounds are values like any: what is flat there, and what a simpler effect would do as
    // well, is said of the model and no reason against it.
    const bool may_be_line = doubt.instead == model::kLineInTime;
    if (may_be_line || doubt.wants_more) return {doubt.sentence, may_be_line, doubt.wants_more};
  }
  // With a free shape the coefficient may be uncertain although the curve is known well: for t <<
  // t0 the logarithm of aging is a line with the slope coefficient / t0.
  const bool judged = own == nullptr && model::shape_parameters({term}).empty();
  return {judged ? model::coefficient_doubt(term) : ""};
}

// "" where the drift in a soak is determined with the addition: better than the drift to be removed
// and, judged by these runs alone, than the error that the model leaves without it. Terms that
// nearly cancel on these runs describe them, and do not cancel in another programme.
std::string undetermined_words(const model::Model& before, const Addition& after) {
  const auto& uncertain = after.model.uncertain;
  if (uncertain && !uncertain->at_power_on && !before.uncertain) {
    return format(
        "with it these runs do not determine the drift: in a soak it is known to +- %.2g "
        "deg/h, and %.2g deg/h are to be compensated",
        uncertain->sigma_dph, uncertain->drift_dph);
  }
  const auto square = [](double value) { return value * value; };
  const double risen = square(after.soak_sigma_after_dph) - square(after.soak_sigma_before_dph);
  if (!after.out_of_sample->within_runs || risen <= square(after.fitted_before_dph)) return "";
  return format(
      "with it the drift in a soak is known to +- %.2g deg/h only, and without it these runs leave "
      "%.2g deg/h: its terms nearly cancel here, and may not in another programme; let a run that "
      "was not fitted decide, with --holdout",
      after.soak_sigma_after_dph, after.fitted_before_dph);
}

}  // namespace

bool is_event(const EffectChange& change) {
  return !change.changed.empty() && searches_steps({change.terms[change.changed.front()]});
}

FitSettings fit_settings(const model::Model& model, const AddSettings& settings) {
  FitSettings fit;
  if (model.network.present()) fit.network_inputs = model.network.inputs;
  fit.identify.run_offsets = settings.run_offsets;
  fit.identify.max_new_steps = 1;  // one at a time: without it further steps may look larger
  fit.network.hidden = static_cast<int>(model.network.hidden.biases.size());
  fit.network.training.seed = settings.seed;
  return fit;
}

std::vector<std::size_t> places_of(const EffectChange& change,
                                   const std::vector<std::size_t>& chosen,
                                   const model::Model& model) {
  std::vector<std::size_t> places;
  for (const std::size_t i : chosen) {
    const auto has_its_name = [&](const model::EffectTerm& term) {
      return term.name == change.terms[i].name;
    };
    const auto found = std::find_if(model.terms.begin(), model.terms.end(), has_its_name);
    places.push_back(static_cast<std::size_t>(found - model.terms.begin()));
  }
  return places;
}

void judge_effects(const FittedPair& pair, Addition& after) {
  const AddSettings& settings = pair.settings;
  const Identification& identified = after.fit.identified;
  const Judge judge{pair, {identified.noise, identified.row_weights, settings.run_offsets}};
  // Few runs are judged by their stretches, and then a walk is asked for: both at once.
  const std::size_t runs = pair.known.series().rows().runs().size();
  const bool few = pair.holdouts.empty() && runs < rules::kEnoughRuns;
  std::optional<double> chance_of_walk;
  std::atomic<bool> has_failed{false};
  for_each_index(few ? 2 : 1, [&](std::size_t i) {
    if (i == 0) {
      judge_rows(judge, after);
      has_failed = settings.verdict_only && !after.out_of_sample->helps();
    } else if (!has_failed) {
      chance_of_walk = ask_walk(judge, after);
    }
  });
  if (has_failed || !after.out_of_sample->within_runs) return;
  after.chance_of_walk = few ? chance_of_walk : ask_walk(judge, after);
}

void judge_network(const FittedPair& pair, Addition& after) {
  after.out_of_sample = after.fit.network_judged;
  if (!after.model.network.present() || pair.holdouts.empty()) return;
  after.out_of_sample = judge_on_holdouts(without_network(after.model), after.model, pair.holdouts,
                                          after.fit.identified.noise, pair.settings.run_offsets);
}

void decide(const model::Model& before, bool has_risen, Addition& after) {
  after.accepted = false;
  after.reason = "its training was interrupted";
  if (!after.out_of_sample) return;
  const OutOfSample& judged = *after.out_of_sample;
  after.reason = format("%s out of sample: %s %s", judged.helps() ? "helps" : "does not help",
                        after.changed.empty() ? "it takes the residual" : "the effects alone leave",
                        out_of_sample_words(judged).c_str());
  if (!judged.helps()) return;
  Doubt doubt;
  for (const std::size_t i : after.changed) {
    if (doubt.sentence.empty()) doubt = doubt_of(after.model.terms[i], before);
  }
  const auto needless = std::find_if(after.parts.begin(), after.parts.end(), is_needless);
  const std::string undetermined = undetermined_words(before, after);
  if (has_risen) {
    after.reason = format("makes the whole model worse on the holdouts: %s -> %s deg/h",
                          rounded(after.holdouts->rms_before_dph).c_str(),
                          rounded(after.holdouts->rms_after_dph).c_str());
  } else if (!doubt.sentence.empty()) {
    after.reason = doubt.sentence;
    after.may_be_line = doubt.may_be_line;
    after.wants_more = doubt.wants_more;
  } else if (!undetermined.empty()) {
    after.reason = undetermined;
  } else if (needless != after.parts.end()) {
    after.reason = needless->effect +
                   " brings nothing beside the others: " + out_of_sample_words(*needless->beside);
  } else if (after.thirds && after.thirds->harms()) {
    after.reason = harm_words(*after.thirds);
  } else if (after.chance_of_walk.value_or(0) >= rules::kMaxChanceOfWalk) {
    after.reason =
        "on these runs alone a random walk of the bias explains it as well: let a run that was not "
        "fitted decide, with --holdout";
  } else {
    after.accepted = true;
  }
}

}  // namespace fogcomp::fit
