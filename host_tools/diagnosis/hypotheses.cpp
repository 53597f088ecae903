#include "diagnosis/hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "diagnosis/decision_rules.hpp"
#include "fit/decision_rules.hpp"
#include "fit/shape_search.hpp"
#include "model/catalogue.hpp"

namespace fogcomp::diagnosis {
namespace {

constexpr std::size_t kExtended = 8;  // pairs that are extended by a third effect
constexpr double kRounding = 1e-9;    // of an evidence: below, the same set found another way

class Search {
 public:
  Search(const fit::ExplainedSpace& space, const std::vector<Candidate>& candidates,
         const RegressorBasis& regressors)
      : space_(space), candidates_(candidates), regressors_(regressors) {}

  std::vector<Hypothesis> run() {
    for (std::size_t i = 0; i < regressors_.size(); ++i) keep(solve({{{i, 0}}}));
    std::vector<Hypothesis> pairs;
    for (std::size_t i = 0; i < regressors_.size(); ++i) {
      for (std::size_t j = i; j < regressors_.size(); ++j) {
        if (i == j && !may_stand_twice(i)) continue;
        pairs.push_back(solve({{{i, alone_[i]}, {j, alone_[j]}}}));
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const Hypothesis& a, const Hypothesis& b) {
      return a.log_evidence > b.log_evidence;
    });
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      keep(pairs[p]);
      if (p >= kExtended) continue;
      for (std::size_t k = 0; k < regressors_.size(); ++k) {
        if (pairs[p].has(k)) continue;
        Hypothesis three = pairs[p];
        three.parts.push_back({k, alone_[k]});
        keep(solve(three));
      }
    }
    weigh();
    return std::move(found_);
  }

 private:
  bool is_step(std::size_t candidate) const { return candidates_[candidate].is_event(); }

  // Whether the effect has an optional second part of the same form.
  bool may_stand_twice(std::size_t candidate) const {
    if (candidates_[candidate].is_expression()) return false;
    const model::CatalogueEntry& entry = model::find_effect(candidates_[candidate].effect);
    return std::any_of(entry.parameters.begin(), entry.parameters.end(), model::is_optional_part);
  }

  // Optimises the shapes jointly, one part at a time.
  Hypothesis solve(Hypothesis h) {
    const std::size_t passes = h.parts.size() == 1 ? 1 : 2;
    double width = 0;
    double unlikely = 0;  // sum of the penalties for averaging over each part's shapes
    for (std::size_t pass = 0; pass < passes; ++pass) {
      unlikely = 0;
      for (std::size_t i = h.parts.size(); i-- > 0;) {
        const BestShape best = best_shape(space_, regressors_[h.parts[i].candidate],
                                          ranges_of(regressors_, h, i), space_.projection());
        h.parts[i].shape = best.shape;
        h.chi2_drop = best.chi2_drop;
        width = fit::column_count(ranges_of(regressors_, h));
        unlikely += fit::log_evidence(best.chi2_drop, width) - best.log_evidence;
      }
    }
    h.log_evidence = fit::log_evidence(h.chi2_drop, width) - unlikely;
    if (h.parts.size() == 1) alone_.push_back(h.parts[0].shape);
    return h;
  }

  // Keeps a set if each part contributes enough.
  void keep(Hypothesis h) {
    for (std::size_t i = 0; i < h.parts.size(); ++i) {
      const std::vector<series::ColumnRange> rest = ranges_of(regressors_, h, i);
      const double without = rest.empty() ? 0 : space_.chi2_drop(rest);
      const bool step = is_step(h.parts[i].candidate);
      const double needed = step           ? rules::kMinStepChi2Drop
                            : rest.empty() ? 0
                                           : rules::kMinPartChi2Drop;
      if (h.chi2_drop - without < needed) return;
    }
    const std::size_t leading = leading_candidate(space_, regressors_, h);
    h.led_by_event = is_step(leading);
    h.free_shape = candidates_[leading].has_free_shape() &&
                   std::none_of(h.parts.begin(), h.parts.end(), [&](const Hypothesis::Part& part) {
                     return candidates_[part.candidate].has_own_input();
                   });
    const auto same = std::find_if(found_.begin(), found_.end(), [&](const Hypothesis& other) {
      return effects_of(other) == effects_of(h);
    });
    if (same == found_.end()) {
      found_.push_back(std::move(h));
    } else if (h.log_evidence > same->log_evidence * (1 + kRounding)) {
      *same = std::move(h);
    }
  }

  // Sorted: a set of three is reached from each of its pairs, with possibly different shapes.
  static std::vector<std::size_t> effects_of(const Hypothesis& h) {
    std::vector<std::size_t> effects;
    for (const Hypothesis::Part& part : h.parts) effects.push_back(part.candidate);
    std::sort(effects.begin(), effects.end());
    return effects;
  }

  // Each further effect is one of those not yet used.
  double log_prior(const Hypothesis& h) const {
    double prior = 0;
    auto left = static_cast<double>(regressors_.size()) - 1;
    for (std::size_t i = 1; i < h.effects(); ++i) {
      prior += std::log(rules::kAnother * static_cast<double>(i + 1) / std::max(1.0, left));
      left -= 1;
    }
    for (const Hypothesis::Part& part : h.parts) {
      const double parameters =
          static_cast<double>(regressors_[part.candidate][part.shape].count) +
          static_cast<double>(
              model::shape_parameters({candidates_[part.candidate].shapes[part.shape].term})
                  .size());
      prior -= std::log(rules::kSimpler) * (parameters - 1);
    }
    return prior;
  }

  void weigh() {
    if (found_.empty()) return;
    double max = 0;
    for (const Hypothesis& h : found_) max = std::max(max, h.log_evidence);
    const double temper = 1 + fit::rules::kModelFormTolerance * 2 * max;
    double best = -HUGE_VAL;
    const auto score = [&](const Hypothesis& h) { return h.log_evidence / temper + h.log_prior; };
    for (Hypothesis& h : found_) {
      h.log_prior = log_prior(h);
      best = std::max(best, score(h));
    }
    double sum = 0;
    for (Hypothesis& h : found_) sum += h.probability = std::exp(score(h) - best);
    for (Hypothesis& h : found_) h.probability /= sum;
    std::sort(found_.begin(), found_.end(), [](const Hypothesis& a, const Hypothesis& b) {
      return a.probability > b.probability;
    });
  }

  const fit::ExplainedSpace& space_;
  const std::vector<Candidate>& candidates_;
  const RegressorBasis& regressors_;
  std::vector<std::size_t> alone_;  // best shape of each candidate by itself
  std::vector<Hypothesis> found_;
};

}  // namespace

std::vector<series::ColumnRange> ranges_of(const RegressorBasis& regressors,
                                           const Hypothesis& hypothesis, std::size_t left_out) {
  std::vector<series::ColumnRange> ranges;
  for (std::size_t i = 0; i < hypothesis.parts.size(); ++i) {
    const Hypothesis::Part& part = hypothesis.parts[i];
    if (i != left_out) ranges.push_back(regressors[part.candidate][part.shape]);
  }
  return ranges;
}

std::size_t leading_candidate(const fit::ExplainedSpace& space, const RegressorBasis& regressors,
                              const Hypothesis& hypothesis) {
  std::size_t best = hypothesis.parts.front().candidate;
  double min = HUGE_VAL;
  for (const Hypothesis::Part& part : hypothesis.parts) {
    std::vector<series::ColumnRange> others;
    for (const Hypothesis::Part& other : hypothesis.parts) {
      if (other.candidate != part.candidate)
        others.push_back(regressors[other.candidate][other.shape]);
    }
    const double chi2_drop = others.empty() ? 0 : space.chi2_drop(others);
    if (chi2_drop >= min) continue;
    min = chi2_drop;
    best = part.candidate;
  }
  return best;
}

bool Hypothesis::has(std::size_t candidate) const {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const Part& part) { return part.candidate == candidate; });
}

std::size_t Hypothesis::shape_of(std::size_t candidate) const {
  return std::find_if(parts.begin(), parts.end(),
                      [&](const Part& part) { return part.candidate == candidate; })
      ->shape;
}

std::size_t Hypothesis::effects() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool first =
        std::none_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const Part& p) { return p.candidate == parts[i].candidate; });
    count += first ? 1 : 0;
  }
  return count;
}

namespace {

// Gives a term the first part of `other` as its optional second part, if it has none yet.
void add_part(model::EffectTerm& term, const model::EffectTerm& other) {
  const auto& parameters = model::find_effect(term.name).parameters;
  for (std::size_t i = 1; i < parameters.size(); ++i) {
    if (!model::is_optional_part(parameters[i]) || term.parameters[i].value != 0) continue;
    double& first = term.parameters[i - 1].value;
    std::tie(first, term.parameters[i].value) = std::minmax({first, other.parameters[i - 1].value});
    return;
  }
}

}  // namespace

model::EffectTerm term_in(const Hypothesis& hypothesis, std::size_t candidate,
                          const std::vector<Candidate>& candidates) {
  std::optional<model::EffectTerm> term;
  for (const Hypothesis::Part& part : hypothesis.parts) {
    if (part.candidate != candidate) continue;
    const model::EffectTerm& one = candidates[candidate].shapes[part.shape].term;
    if (term) {
      add_part(*term, one);
    } else {
      term = one;
    }
  }
  return *term;
}

BestShape best_shape(const fit::ExplainedSpace& space,
                     const std::vector<series::ColumnRange>& shapes,
                     const std::vector<series::ColumnRange>& others,
                     const Eigen::VectorXd& projection) {
  std::vector<series::ColumnRange> parts = others;
  parts.push_back({});
  std::vector<double> drops;
  std::vector<double> columns;
  for (const series::ColumnRange& shape : shapes) {
    parts.back() = shape;
    drops.push_back(space.chi2_drop(parts, projection));
    columns.push_back(fit::column_count(parts));
  }
  return best_of_drops(drops, columns);
}

BestShape best_of_drops(const std::vector<double>& drops, const std::vector<double>& columns) {
  BestShape best;
  std::vector<double> evidence(drops.size());
  for (std::size_t shape = 0; shape < drops.size(); ++shape) {
    evidence[shape] = fit::log_evidence(drops[shape], columns[shape]);
    if (shape > 0 && drops[shape] <= best.chi2_drop) continue;
    best.chi2_drop = drops[shape];
    best.shape = shape;
  }
  const double max = *std::max_element(evidence.begin(), evidence.end());
  double sum = 0;
  for (const double one : evidence) sum += std::exp(one - max);
  best.log_evidence = max + std::log(sum / static_cast<double>(drops.size()));
  return best;
}

std::vector<Hypothesis> find_hypotheses(const fit::ExplainedSpace& space,
                                        const std::vector<Candidate>& candidates,
                                        const RegressorBasis& regressors) {
  return Search(space, candidates, regressors).run();
}

}  // namespace fogcomp::diagnosis
