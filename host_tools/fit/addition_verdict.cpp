#include "fit/addition_verdict.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <utility>

#include "fit/decision_rules.hpp"
#include "model/catalogue.hpp"
#include "noise/outlier_rows.hpp"
#include "support/input_error.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

model::Model without_network(model::Model model) {
  model.network = {};
  return model;
}

std::vector<std::size_t> refined_terms(const FittedPair& pair) {
  std::vector<std::size_t> refined;
  for (const std::size_t i : pair.change.changed) {
    if (i < pair.before.terms.size()) refined.push_back(i);
  }
  return refined;
}

// Compares two models out of sample: a holdout is one more part that is left out, from which
// nothing was learnt before.
class Judge {
 public:
  Judge(const FittedPair& judged, const Addition& after)
      : pair(judged),
        with_{after.fit.identified.noise, after.fit.identified.row_weights,
              judged.settings.run_offsets, refined_terms(judged)} {
    if (pair.runs.holdouts.empty() || !pair.change.cuts.empty()) return;
    all_ = std::make_unique<KnownRegressors>(after.model, pair.runs.all());
    const series::Rows& rows = all_->series().rows();
    weights_ = rows.weights.cwiseProduct(noise::counted_rows(rows));
    weights_.head(with_.row_weights.size()) = with_.row_weights;
  }

  OutOfSample operator()(const model::Model& before, const model::Model& after) const {
    if (!all_) return on_training_runs(before, after).on_runs_or_stretches();
    OutOfSample judged = judge_on_holdouts(without_network(before), without_network(after),
                                           pair.runs.holdouts, with_.noise, with_.run_offsets);
    const series::Rows& rows = all_->series().rows();
    const CrossValidation validation(*all_, {before.terms, rows}, {after.terms, rows},
                                     {with_.noise, weights_, with_.run_offsets, with_.refined});
    judged.score =
        validation.on_rows_from(static_cast<std::size_t>(with_.row_weights.size())).score;
    return judged;
  }
  CrossValidation on_training_runs(const model::Model& before, const model::Model& after) const {
    return {pair.known,
            {before.terms, pair.biases_before},
            {after.terms, pair.known.series().rows()},
            with_};
  }

  const FittedPair& pair;

 private:
  JudgedWith with_;
  std::unique_ptr<const KnownRegressors> all_;  // of training runs, then holdouts
  Eigen::VectorXd weights_;                     // of its rows
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

// Judges what `after` has more than `before`; nothing if the data determine it only together with
// others.
std::optional<OutOfSample> judge_part(const Judge& judge, const PartsOfSet& models,
                                      const PartsOfSet::Subset& before,
                                      const PartsOfSet::Subset& after) {
  const std::optional<model::Model>& without = models.with(before);
  const std::optional<model::Model>& with = models.with(after);
  if (!without || !with) return std::nullopt;
  return judge(*without, *with);
}

bool is_needless(const Addition::Part& part) {
  return part.beside && !part.beside->score.improves();
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
    if (!verdict_only) parts[i].alone = judge_part(judge, models, {}, {all[i]});
    parts[i].beside = judge_part(judge, models, all_but(all, all[i]), all);
    *own = is_needless(parts[i]);
  });
  const auto first = std::find_if(parts.begin(), parts.end(), is_needless);
  if (verdict_only && first != parts.end()) parts.erase(first + 1, parts.end());
  return parts;
}

std::vector<model::EffectTerm> changed_terms(const Addition& addition) {
  std::vector<model::EffectTerm> terms;
  for (const std::size_t i : addition.changed) terms.push_back(addition.model.terms[i]);
  return terms;
}

const OutOfSample* harmed(const AdditionVerdict& verdict) {
  const auto found = std::find_if(verdict.far.begin(), verdict.far.end(),
                                  [](const OutOfSample& one) { return harms(one); });
  return found == verdict.far.end() ? nullptr : &*found;
}

}  // namespace

FitSettings fit_settings(const model::Model& model, const AddSettings& settings) {
  FitSettings fit;
  if (model.network.present()) fit.network_inputs = model.network.inputs;
  fit.identify.run_offsets = settings.run_offsets;
  fit.network.hidden = static_cast<int>(model.network.hidden.biases.size());
  fit.network.training.seed = settings.seed;
  return fit;
}

void judge_effects(const FittedPair& pair, Addition& after) {
  const Judge judge(pair, after);
  const bool verdict_only = pair.settings.verdict_only;
  if (!pair.runs.holdouts.empty() && pair.change.cuts.empty()) {
    after.out_of_sample = judge(pair.before, after.model);
  } else {
    const CrossValidation validation = judge.on_training_runs(pair.before, after.model);
    after.out_of_sample = validation.on_runs_or_stretches();
    if (verdict_only && !after.out_of_sample->score.improves()) return;
    if (!pair.change.cuts.empty()) return;  // says nothing of other rows
    for (const FarPart& far : far_parts(pair.known.series().rows(), changed_terms(after))) {
      if (validation.can_foretell(far.part)) after.far.push_back(validation.on(far));
    }
  }
  const bool has_failed = !after.out_of_sample->score.improves() || harmed(after) != nullptr;
  if (pair.change.changed.size() < 2 || (verdict_only && has_failed)) return;
  PartsOfSet models(pair, after.model);
  after.parts = judge_parts(judge, models);
}

void judge_network(const FittedPair& pair, Addition& after) {
  after.out_of_sample = after.fit.network_judged;
  if (!after.model.network.present() || pair.runs.holdouts.empty()) return;
  after.out_of_sample =
      judge_on_holdouts(without_network(after.model), after.model, pair.runs.holdouts,
                        after.fit.identified.noise, pair.settings.run_offsets);
}

void decide(Addition& after) {
  after.accepted = false;
  after.reason = "its training was interrupted";
  if (!after.out_of_sample) return;
  const OutOfSample& judged = *after.out_of_sample;
  const bool is_better = after.is_network() ? helps(judged) : judged.score.improves();
  after.reason =
      after.cuts.empty()
          ? format("%s out of sample: %s %s",
                   !is_better ? "does not help"
                   : judged.rms_after_dph <= judged.rms_before_dph
                       ? "helps"
                       : "makes rows more probable, although their error rises,",
                   after.is_network() ? "it takes the residual" : "the effects alone leave",
                   out_of_sample_words(judged).c_str())
          // says nothing of other rows
          : (is_better ? "the bias jumps there: " : "no jump of the bias shows there: ") +
                gain_words(judged.score);
  if (!is_better) return;
  const auto needless = std::find_if(after.parts.begin(), after.parts.end(), is_needless);
  const OutOfSample* const harm = harmed(after);
  if (after.whole && after.whole->rms_after_dph > after.whole->rms_before_dph &&
      after.whole->score.harms()) {
    after.reason =
        "makes the whole model worse on the holdouts: " + out_of_sample_words(*after.whole);
  } else if (harm != nullptr) {
    after.reason = "it raises the error far from the rows fitted: " + out_of_sample_words(*harm);
  } else if (needless != after.parts.end()) {
    after.needless = needless->effect;
    after.reason = needless->effect +
                   " brings nothing beside the others: " + out_of_sample_words(*needless->beside);
  } else {
    after.accepted = true;
  }
}

}  // namespace fogcomp::fit
