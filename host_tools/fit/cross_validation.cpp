#include "fit/cross_validation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

#include "fit/decision_rules.hpp"
#include "fit/left_out_parts.hpp"
#include "model/shape_parameter.hpp"
#include "noise/outlier_rows.hpp"
#include "support/parallel.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {

// Parts that were left out each, and the fits of both sets without them.
struct CrossValidation::LeftOut {
  LeftOut(std::vector<Part> given, const KnownRegressors& known, const JudgedWith& with)
      : parts(std::move(given)), remaining(parts.size()), folds(parts.size()) {
    for_each_index(parts.size(),
                   [&](std::size_t i) { remaining[i].emplace(known, parts[i], with); });
  }

  std::vector<Part> parts;
  std::vector<std::optional<RemainingRows>> remaining;
  std::vector<Pair> folds;

  // For each part, whether it can judge: not if the other rows leave a coefficient undetermined.
  std::vector<bool> which_judge(const Pair& all) const {
    std::vector<bool> judges;
    for (const Pair& fold : folds) {
      judges.push_back(determines_all(fold.before, all.before) &&
                       determines_all(fold.after, all.after));
    }
    return judges;
  }

  // A value per row: in the rows of each part that judges those of values_of(part), else 0.
  Eigen::VectorXd joined(const std::vector<bool>& judges,
                         const std::function<Eigen::VectorXd(std::size_t)>& values_of) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(folds[0].after.residual_dph.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!judges[i]) continue;
      const Eigen::VectorXd values = values_of(i);
      for (const recording::RowRange& range : parts[i]) {
        series::of_rows(all, range) = series::of_rows(values, range);
      }
    }
    return all;
  }
};

CrossValidation::CrossValidation(const KnownRegressors& known,
                                 const std::vector<model::EffectTerm>& before,
                                 const std::vector<model::EffectTerm>& after,
                                 std::vector<std::size_t> changed, const JudgedWith& with)
    : known_(known),
      rows_(known.series().rows()),
      before_(model::with_fixed_shapes(before)),
      after_(model::with_fixed_shapes(after, changed)),
      changed_(std::move(changed)),
      with_(with),
      all_(std::move(leave_out_each({{}}).folds.front())) {}

CrossValidation::LeftOut CrossValidation::leave_out_each(std::vector<Part> parts) const {
  LeftOut left(std::move(parts), known_, with_);
  for_each_index(2 * left.parts.size(), [&](std::size_t i) {
    i % 2 == 0 ? fit_after(i / 2, left) : fit_before(i / 2, left);
  });
  return left;
}

void CrossValidation::fit_after(std::size_t part, LeftOut& left) const {
  left.folds[part].after = fit_to(*left.remaining[part], known_, after_, with_);
}

void CrossValidation::fit_before(std::size_t part, LeftOut& left) const {
  left.folds[part].before = fit_to(*left.remaining[part], known_, before_, with_);
}

bool CrossValidation::determine_changed(const Fold& after) const {
  return determines_terms(after, all_.after, known_, after_, changed_);
}

bool CrossValidation::all_determine_changed(const LeftOut& left) const {
  return std::all_of(left.folds.begin(), left.folds.end(),
                     [&](const Pair& fold) { return determine_changed(fold.after); });
}

// Nothing if without one of the parts a changed term is undetermined: then the fits that have not
// begun are not made.
std::optional<CrossValidation::LeftOut> CrossValidation::leave_out_if_determined(
    std::vector<Part> parts) const {
  LeftOut left(std::move(parts), known_, with_);
  std::atomic<bool> is_determined{true};
  for_each_index(left.parts.size(), [&](std::size_t i) {
    if (!is_determined) return;
    fit_after(i, left);
    if (!determine_changed(left.folds[i].after)) is_determined = false;
  });
  if (!is_determined) return std::nullopt;
  for_each_index(left.parts.size(), [&](std::size_t i) { fit_before(i, left); });
  return left;
}

// On the rows of the parts that judge.
OutOfSample CrossValidation::judge(const LeftOut& left, const std::vector<bool>& judges,
                                   std::string how) const {
  const auto weights = left.joined(judges, [&](std::size_t) { return with_.row_weights; });
  OutOfSample result = judge_residuals(
      rows_, left.joined(judges, [&](std::size_t i) { return left.folds[i].before.residual_dph; }),
      left.joined(judges, [&](std::size_t i) { return left.folds[i].after.residual_dph; }),
      with_.noise, weights);
  result.how = std::move(how);
  return result;
}

// Nothing if the runs do not determine each other.
std::optional<OutOfSample> CrossValidation::on_runs() const {
  std::vector<Part> runs;
  for (const recording::RowRange& run : rows_.runs()) runs.push_back({run});
  const LeftOut left = leave_out_each(std::move(runs));
  const std::vector<bool> judges = left.which_judge(all_);
  const auto count = static_cast<std::size_t>(std::count(judges.begin(), judges.end(), true));
  if (count < 2 || !all_determine_changed(left)) return std::nullopt;
  const std::string of = count < judges.size() ? std::to_string(count) + " of " : "";
  return judge(left, judges, "on " + of + counted(judges.size(), "run") + ", each left out once");
}

// The start of a run may be one stretch, without which nothing is known of a warm-up: then more.
OutOfSample CrossValidation::on_stretches(double count) const {
  const double max = static_cast<double>(rows_.size()) / rules::kMinRowsOfShort;
  const bool may_be_shorter = with_.noise.from_quiet_parts && all_.after.determined;
  std::optional<LeftOut> found;
  for (double each = count; may_be_shorter && !found && each <= max; each *= rules::kShorter) {
    found = leave_out_if_determined(parts_of(rows_, each));
  }
  const LeftOut left = found ? std::move(*found) : leave_out_each(parts_of(rows_, count));
  std::vector<bool> judges = left.which_judge(all_);
  if (std::none_of(judges.begin(), judges.end(), [](bool one) { return one; })) {
    judges.assign(judges.size(), true);
  }
  OutOfSample result = judge(left, judges, how_of(left.parts, rows_));
  result.within_runs = true;
  return result;
}

OutOfSample CrossValidation::on_runs_or_stretches() const {
  if (rows_.runs().size() >= rules::kEnoughRuns) {
    if (auto result = on_runs()) return *result;
  }
  const Eigen::VectorXd residual = rows_.drift_dph - known_.series().drift_dph(after_);
  return on_stretches(stretches_of(rows_, {residual.begin(), residual.end()}, with_.noise));
}

std::optional<OutOfSample> CrossValidation::judge_far(const LeftOut& left, std::string how) const {
  std::vector<bool> judges = left.which_judge(all_);
  for (std::size_t i = 0; i < judges.size(); ++i) {
    judges[i] = judges[i] && !left.parts[i].empty() && determine_changed(left.folds[i].after);
  }
  if (std::none_of(judges.begin(), judges.end(), [](bool one) { return one; })) return {};
  OutOfSample result = judge(left, judges, std::move(how));
  result.within_runs = true;
  return result;
}

std::optional<OutOfSample> CrossValidation::on_far_rows(FarRows far) const {
  if (far == FarRows::thirds) {
    return judge_far(leave_out_each(cut_runs(rows_, 3)),
                     "on thirds of every run, each left out once");
  }
  return judge_far(leave_out_each(directions_of(rows_)),
                   "on heating and cooling, each left out once");
}

TemperatureTest CrossValidation::on_temperatures() const {
  const LeftOut left = leave_out_each(temperatures_of(rows_));
  TemperatureTest test{judge_far(left, "on thirds of the temperatures, each left out once")};
  const std::vector<bool> everywhere(left.parts.size(), true);
  const Eigen::VectorXd weights = noise::counted_weights(rows_, with_.row_weights);
  const auto rms = [&](const std::function<Eigen::VectorXd(std::size_t)>& values_of) {
    return weighted_rms(left.joined(everywhere, values_of), weights);
  };
  test.rms_before_dph = rms([&](std::size_t i) { return left.folds[i].before.residual_dph; });
  test.rms_after_dph = rms([&](std::size_t i) { return left.folds[i].after.residual_dph; });
  if (test.rms_after_dph <= test.rms_before_dph) return test;
  const double uncertain_dph = rms([&](std::size_t i) {
    return prediction_sigma_dph(known_, left.folds[i].after, *left.remaining[i]);
  });
  test.rms_expected_dph = std::hypot(weighted_rms(all_.after.residual_dph, weights), uncertain_dph);
  return test;
}

std::vector<HalfTest> CrossValidation::on_halves() const {
  const LeftOut left = leave_out_each(cut_runs(rows_, 2));
  std::vector<HalfTest> tests;
  for (const bool on_first : {true, false}) {
    const std::size_t judged = on_first ? 1 : 0;
    const Pair& fold = left.folds[judged];
    HalfTest test;
    test.identified_on = on_first ? "first" : "second";
    test.determined = fold.before.determined && determines_all(fold.after, all_.after);
    Eigen::VectorXd weights = noise::counted_weights(rows_, with_.row_weights);
    for (const recording::RowRange& range : left.parts[1 - judged]) {
      series::of_rows(weights, range).setZero();
    }
    test.rms_before_dph = weighted_rms(fold.before.residual_dph, weights);
    test.rms_after_dph = weighted_rms(fold.after.residual_dph, weights);
    tests.push_back(test);
  }
  return tests;
}

OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner) {
  const std::vector<Part> parts = parts_of(rows, rules::kMaxStretches);
  Eigen::VectorXd after = residual_dph;
  for (const Part& part : parts) {
    Eigen::VectorXd weights = with.row_weights;
    for (const recording::RowRange& range : part) series::of_rows(weights, range).setZero();
    Eigen::VectorXd learnt = learner(weights);
    for (const recording::RowRange& range : part)
      series::of_rows(after, range) -= series::of_rows(learnt, range);
  }
  OutOfSample result = judge_residuals(rows, residual_dph, after, with.noise, with.row_weights);
  result.how = how_of(parts, rows);
  result.within_runs = true;
  return result;
}

std::string half_words(const HalfTest& half) {
  const std::string on = half.identified_on;
  if (!half.determined) return "the " + on + " half alone cannot identify this model";
  return format("identified on the %s half, judged on the %s: %s -> %s%s", on.c_str(),
                on == "first" ? "second" : "first", rounded(half.rms_before_dph).c_str(),
                rounded(half.rms_after_dph).c_str(),
                half.rms_after_dph < half.rms_before_dph ? "" : ", does not hold there");
}

bool TemperatureTest::fails() const {
  return rms_after_dph > rms_before_dph &&
         rms_after_dph > rules::kBeyondExpected * rms_expected_dph;
}

std::string failure_words(const TemperatureTest& test) {
  return format(
      "it fails at temperatures that were not fitted: %s -> %s deg/h in thirds of them left out, "
      "where %s were to be expected",
      rounded(test.rms_before_dph).c_str(), rounded(test.rms_after_dph).c_str(),
      rounded(test.rms_expected_dph).c_str());
}

}  // namespace fogcomp::fit
