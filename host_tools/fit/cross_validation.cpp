#include "fit/cross_validation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "fit/decision_rules.hpp"
#include "fit/left_out_parts.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/shape_search.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

auto segment(Eigen::VectorXd& values, const recording::RowRange& range) {
  return values.segment(static_cast<Eigen::Index>(range.first),
                        static_cast<Eigen::Index>(range.size()));
}

// Residual in all rows of a set of effects that was identified without the rows of `left_out`.
struct Fold {
  Eigen::VectorXd residual_dph;
  bool determined = false;    // the other rows determine every coefficient
  Eigen::VectorXd sigma_dph;  // of the coefficients, if determined
};

// A bias of its own for each run that is fitted, but for the first of these.
Eigen::MatrixXd offsets_of_fitted(const series::Rows& rows, const Eigen::VectorXd& weights) {
  std::vector<Eigen::MatrixXd> columns;
  bool is_first = true;
  for (const recording::RowRange& run : rows.runs()) {
    const bool is_fitted =
        weights.segment(static_cast<Eigen::Index>(run.first), static_cast<Eigen::Index>(run.size()))
            .any();
    if (is_fitted && !is_first) columns.emplace_back(step_column(rows, run.first));
    is_first = is_first && !is_fitted;
  }
  return side_by_side(columns, rows.size());
}

// The bias of a run that is left out whole is unknown: its mean residual says nothing.
void take_out_unknown_offsets(const series::Rows& rows, const Eigen::VectorXd& fitted,
                              const Eigen::VectorXd& row_weights, Fold& fold) {
  for (const recording::RowRange& run : rows.runs()) {
    const auto part = [&](const Eigen::VectorXd& values) {
      return values.segment(static_cast<Eigen::Index>(run.first),
                            static_cast<Eigen::Index>(run.size()));
    };
    const double weight = part(row_weights).sum();
    if (part(fitted).any() || weight <= 0) continue;
    segment(fold.residual_dph, run).array() -=
        part(fold.residual_dph).dot(part(row_weights)) / weight;
  }
}

Fold leave_out(const KnownRegressors& known, const std::vector<model::EffectTerm>& terms,
               const Part& left_out, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  Eigen::VectorXd weights = with.row_weights;
  for (const recording::RowRange& range : left_out) segment(weights, range).setZero();
  const noise::Whitening whitening(with.noise, rows, weights);
  const Eigen::MatrixXd offsets =
      with.run_offsets ? offsets_of_fitted(rows, weights) : Eigen::MatrixXd(rows.size(), 0);
  WhitenedProblem problem(known, whitening, terms, offsets);
  const std::vector<model::ShapeParameter> shapes = model::shape_parameters(terms);
  // On all rows the shapes were found: by the fit that is judged.
  search_shapes(problem, shapes, std::vector<bool>(shapes.size(), !left_out.empty()));
  const LinearFit fit = problem.solve();
  Fold fold;
  fold.determined = fit.rank == fit.coefficients.size();
  if (fold.determined) fold.sigma_dph = fit.covariance.diagonal().cwiseSqrt();
  fold.residual_dph = rows.drift_dph;
  Eigen::Index column = 0;
  for (const model::EffectTerm& term : problem.terms()) {
    const KnownRegressors::Columns regressors = known(term);
    fold.residual_dph -= *regressors * fit.coefficients.segment(column, regressors->cols());
    column += regressors->cols();
  }
  fold.residual_dph -= offsets * fit.coefficients.tail(offsets.cols());
  if (with.run_offsets) take_out_unknown_offsets(rows, weights, with.row_weights, fold);
  return fold;
}

// Whether the rows of `fold` determine some coefficients about as well as all rows do. A run that
// did not excite an effect cannot judge a run that did.
bool determines(const Fold& fold, const Fold& all, Eigen::Index first, Eigen::Index count,
                double much_worse) {
  if (!fold.determined || !all.determined) return false;
  return (fold.sigma_dph.segment(first, count).array() <=
          much_worse * all.sigma_dph.segment(first, count).array())
      .all();
}
bool determines_all(const Fold& fold, const Fold& all) {
  return determines(fold, all, 0, all.sigma_dph.size(), rules::kFarWorse);
}

// Fixes all shapes but those of one term.
std::vector<model::EffectTerm> with_fixed_shapes(std::vector<model::EffectTerm> terms,
                                                 const std::vector<std::size_t>& free) {
  for (std::size_t i = 0; i < terms.size(); ++i) {
    if (std::find(free.begin(), free.end(), i) == free.end())
      std::fill(terms[i].identified.begin(), terms[i].identified.end(), false);
  }
  return terms;
}

struct Residuals {
  Eigen::VectorXd before;
  Eigen::VectorXd after;
  std::vector<Fold> given;  // of `before`, one for each part left out
  std::vector<Fold> added;  // of `after`
};

Residuals leave_each_out(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                         const std::vector<model::EffectTerm>& after,
                         const std::vector<Part>& parts, const JudgedWith& with) {
  Residuals residuals{Eigen::VectorXd(known.series().rows().size()),
                      Eigen::VectorXd(known.series().rows().size()),
                      std::vector<Fold>(parts.size()), std::vector<Fold>(parts.size())};
  for_each_index(2 * parts.size(), [&](std::size_t i) {
    const std::size_t part = i / 2;
    Fold& fold = i % 2 == 0 ? residuals.given[part] : residuals.added[part];
    fold = leave_out(known, i % 2 == 0 ? before : after, parts[part], with);
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const recording::RowRange& range : parts[i]) {
      segment(residuals.before, range) = segment(residuals.given[i].residual_dph, range);
      segment(residuals.after, range) = segment(residuals.added[i].residual_dph, range);
    }
  }
  return residuals;
}

// Whether every fold determines the coefficients of some terms.
bool determine_terms(const std::vector<Fold>& folds, const Fold& all, const KnownRegressors& known,
                     const std::vector<model::EffectTerm>& terms,
                     const std::vector<std::size_t>& asked) {
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Eigen::Index count = known(terms[i])->cols();
    const bool determined = std::all_of(folds.begin(), folds.end(), [&](const Fold& fold) {
      return determines(fold, all, first, count, rules::kMuchWorse);
    });
    if (!determined && std::find(asked.begin(), asked.end(), i) != asked.end()) return false;
    first += count;
  }
  return true;
}

// Both models identified on all rows.
struct OnAllRows {
  Fold before;
  Fold after;
};

// For each part, whether it can judge: not if the other rows leave a coefficient undetermined (a
// warm-up without the start of its run, a polynomial without the only run that is cold).
std::vector<bool> which_judge(const Residuals& left, const OnAllRows& all) {
  std::vector<bool> judges;
  for (std::size_t i = 0; i < left.given.size(); ++i) {
    judges.push_back(determines_all(left.given[i], all.before) &&
                     determines_all(left.added[i], all.after));
  }
  return judges;
}

// All rows but those of the parts that judge get weight 0.
Eigen::VectorXd weights_of(const std::vector<Part>& parts, const std::vector<bool>& judges,
                           Eigen::VectorXd row_weights) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(row_weights.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!judges[i]) continue;
    for (const recording::RowRange& range : parts[i]) {
      segment(weights, range) = segment(row_weights, range);
    }
  }
  return weights;
}

// Two sets of effects, `changed` those that the first lacks, identified without each part of the
// rows and judged there.
class CrossValidation {
 public:
  CrossValidation(const KnownRegressors& known, const std::vector<model::EffectTerm>& before,
                  const std::vector<model::EffectTerm>& after,
                  const std::vector<std::size_t>& changed, const JudgedWith& with)
      : rows_(known.series().rows()),
        known_(known),
        before_(with_fixed_shapes(before, {})),
        after_(with_fixed_shapes(after, changed)),
        changed_(changed),
        with_(with) {
    for_each_index(2, [&](std::size_t i) {
      (i == 0 ? all_.before : all_.after) = leave_out(known_, i == 0 ? before_ : after_, {}, with);
    });
  }

  // Nothing if the runs do not determine each other.
  std::optional<OutOfSample> on_runs() {
    const std::vector<recording::RowRange> runs = rows_.runs();
    std::vector<Part> parts;
    for (const recording::RowRange& run : runs) parts.push_back({run});
    const Residuals left = leave_out_each_of(parts);
    const std::vector<bool> judges = which_judge(left, all_);
    const auto count = static_cast<std::size_t>(std::count(judges.begin(), judges.end(), true));
    if (count < 2 || !determine_changed(left)) return std::nullopt;
    OutOfSample result = judge_residuals(rows_, left.before, left.after, with_.noise,
                                         weights_of(parts, judges, with_.row_weights));
    const std::string of = count < runs.size() ? std::to_string(count) + " of " : "";
    result.how = "on " + of + counted(runs.size(), "run") + ", each left out once";
    return result;
  }

  // Nothing if no part counts.
  std::optional<OutOfSample> on_parts(const std::vector<Part>& parts, const std::string& how) {
    const Residuals left = leave_out_each_of(parts);
    std::vector<bool> judges = which_judge(left, all_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      judges[i] = judges[i] && !parts[i].empty() &&
                  determine_terms({left.added[i]}, all_.after, known_, after_, changed_);
    }
    if (std::none_of(judges.begin(), judges.end(), [](bool one) { return one; })) {
      return std::nullopt;
    }
    OutOfSample result = judge_residuals(rows_, left.before, left.after, with_.noise,
                                         weights_of(parts, judges, with_.row_weights));
    result.how = how;
    result.within_runs = true;
    return result;
  }

  // `count`: of the stretches, or more: the start of a run may be one stretch, without which
  // nothing is known of a warm-up.
  OutOfSample on_stretches(double count) {
    std::vector<Part> parts = parts_of(rows_, count);
    Residuals left = leave_out_each_of(parts);
    const double max = static_cast<double>(rows_.size()) / rules::kMinRowsOfShort;
    bool is_enough = determine_changed(left) || !with_.noise.from_quiet_parts;
    while (!is_enough && all_.after.determined && count * rules::kShorter <= max) {
      count *= rules::kShorter;
      std::vector<Part> shorter = parts_of(rows_, count);
      Residuals without = leave_out_each_of(shorter);
      is_enough = determine_changed(without);
      if (!is_enough) continue;
      parts = std::move(shorter);
      left = std::move(without);
    }
    const Eigen::VectorXd weights = weights_of(parts, which_judge(left, all_), with_.row_weights);
    OutOfSample result = judge_residuals(rows_, left.before, left.after, with_.noise,
                                         weights.any() ? weights : with_.row_weights);
    result.how = how_of(parts, rows_);
    result.within_runs = true;
    return result;
  }

 private:
  Residuals leave_out_each_of(const std::vector<Part>& parts) {
    return leave_each_out(known_, before_, after_, parts, with_);
  }
  bool determine_changed(const Residuals& left) {
    return determine_terms(left.added, all_.after, known_, after_, changed_);
  }

  const series::Rows& rows_;
  const KnownRegressors& known_;
  std::vector<model::EffectTerm> before_;
  std::vector<model::EffectTerm> after_;
  const std::vector<std::size_t>& changed_;
  const JudgedWith& with_;
  OnAllRows all_;
};

}  // namespace

OutOfSample cross_validate(const KnownRegressors& known,
                           const std::vector<model::EffectTerm>& before,
                           const std::vector<model::EffectTerm>& after,
                           const std::vector<std::size_t>& changed, const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  CrossValidation validation(known, before, after, changed, with);
  if (rows.runs().size() >= rules::kEnoughRuns) {
    if (auto result = validation.on_runs()) return *result;
  }
  const Eigen::VectorXd residual = rows.drift_dph - known.series().drift_dph(after);
  return validation.on_stretches(
      stretches_of(rows, {residual.begin(), residual.end()}, with.noise));
}

std::optional<OutOfSample> judge_far_rows(const KnownRegressors& known,
                                          const std::vector<model::EffectTerm>& before,
                                          const std::vector<model::EffectTerm>& after,
                                          const std::vector<std::size_t>& changed,
                                          const JudgedWith& with, FarRows parts) {
  const series::Rows& rows = known.series().rows();
  CrossValidation validation(known, before, after, changed, with);
  return parts == FarRows::thirds
             ? validation.on_parts(cut_runs(rows, 3), "on thirds of every run, each left out once")
             : validation.on_parts(directions_of(rows),
                                   "on heating and cooling, each left out once");
}

bool others_determine(const KnownRegressors& known, const std::vector<model::EffectTerm>& after,
                      const std::vector<std::size_t>& changed, std::size_t run,
                      const JudgedWith& with) {
  const std::vector<model::EffectTerm> terms = with_fixed_shapes(after, changed);
  const Fold all = leave_out(known, terms, {}, with);
  const Fold others = leave_out(known, terms, {known.series().rows().runs()[run]}, with);
  return determine_terms({others}, all, known, terms, changed);
}

OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner) {
  const std::vector<Part> parts = parts_of(rows, rules::kMaxStretches);
  Eigen::VectorXd after = residual_dph;
  for (const Part& part : parts) {
    Eigen::VectorXd weights = with.row_weights;
    for (const recording::RowRange& range : part) segment(weights, range).setZero();
    Eigen::VectorXd learnt = learner(weights);
    for (const recording::RowRange& range : part) segment(after, range) -= segment(learnt, range);
  }
  OutOfSample result = judge_residuals(rows, residual_dph, after, with.noise, with.row_weights);
  result.how = how_of(parts, rows);
  result.within_runs = true;
  return result;
}

std::vector<HalfTest> judge_halves(const KnownRegressors& known,
                                   const std::vector<model::EffectTerm>& before,
                                   const std::vector<model::EffectTerm>& after,
                                   const std::vector<std::size_t>& changed,
                                   const JudgedWith& with) {
  const series::Rows& rows = known.series().rows();
  const std::vector<Part> halves = cut_runs(rows, 2);
  const Part& first = halves[0];
  const Part& second = halves[1];
  const Fold all = leave_out(known, with_fixed_shapes(after, {}), {}, with);
  std::vector<HalfTest> tests;
  for (const bool on_first : {true, false}) {
    const Part& judged = on_first ? second : first;
    const Fold without = leave_out(known, with_fixed_shapes(before, {}), judged, with);
    const Fold added = leave_out(known, with_fixed_shapes(after, changed), judged, with);
    HalfTest test;
    test.identified_on = on_first ? "first" : "second";
    test.determined = without.determined && determines_all(added, all);
    Eigen::VectorXd weights = noise::counted_weights(rows, with.row_weights);
    for (const recording::RowRange& range : on_first ? first : second)
      segment(weights, range).setZero();
    test.rms_before_dph = weighted_rms(without.residual_dph, weights);
    test.rms_after_dph = weighted_rms(added.residual_dph, weights);
    tests.push_back(test);
  }
  return tests;
}

std::string half_words(const HalfTest& half) {
  const std::string on = half.identified_on;
  if (!half.determined) return "the " + on + " half alone cannot identify this model";
  return format("identified on the %s half, judged on the %s: %s -> %s%s", on.c_str(),
                on == "first" ? "second" : "first", rounded(half.rms_before_dph).c_str(),
                rounded(half.rms_after_dph).c_str(),
                half.rms_after_dph < half.rms_before_dph ? "" : ", does not hold there");
}

}  // namespace fogcomp::fit
