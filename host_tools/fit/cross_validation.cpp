#include "fit/cross_validation.hpp"

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "fit/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/whitening.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

// Of a typical part, as the score sees it: a sum of logarithms. An rms over all parts would be that
// of the one that is farthest from what the others tell.
double typical_rms(const Eigen::VectorXd& residual_dph, const Eigen::VectorXd& weights,
                   const std::vector<Part>& parts) {
  double logarithms = 0;
  double rows = 0;
  for (const Part& part : parts) {
    Eigen::VectorXd own = Eigen::VectorXd::Zero(weights.size());
    for (const recording::RowRange& range : part) {
      series::of_rows(own, range) = series::of_rows(weights, range);
    }
    const double count = own.sum();
    if (count <= 0) continue;
    logarithms += count * std::log(weighted_rms(residual_dph, own));
    rows += count;
  }
  return std::exp(logarithms / rows);
}

Eigen::VectorXd residual_on(const model::Model& model, const std::vector<runs::Run>& runs,
                            bool run_offsets) {
  std::vector<double> residual;
  for (const runs::Run& run : runs) {
    const compare::Comparison comparison = compare::compare_with(model, run, model.average_s);
    const std::vector<double> of_run =
        run_offsets ? comparison.residuals_about_bias_dph() : comparison.residuals_dph();
    residual.insert(residual.end(), of_run.begin(), of_run.end());
  }
  return Eigen::Map<const Eigen::VectorXd>(residual.data(),
                                           static_cast<Eigen::Index>(residual.size()));
}

// Each row from what is left of those before it.
judge::Foretold foretold(const noise::Whitening& whitening, const Eigen::VectorXd& left,
                         const Eigen::VectorXd& weights) {
  const Eigen::ArrayXd sigma = whitening.scale().array().inverse();
  const Eigen::ArrayXd surprise = whitening.apply(left).col(0).array() * sigma;
  return {-surprise, (weights.array() > 0).select(sigma.square(), 0)};
}

}  // namespace

CrossValidation::CrossValidation(const KnownRegressors& known, const JudgedEffects& before,
                                 const JudgedEffects& after, const JudgedWith& with)
    : rows_(known.series().rows()),
      biases_before_(before.biases),
      biases_after_(after.biases),
      weights_(with.row_weights),
      run_offsets_(with.run_offsets),
      before_(known, before, with),
      after_(known, after, with) {}

OutOfSample CrossValidation::on(const Folds& folds) const {
  if (std::none_of(folds.parts.begin(), folds.parts.end(),
                   [&](const Part& part) { return can_foretell(part); })) {
    throw InputError("add",
                     "too few rows: the first minutes of a run, in which the board's "
                     "temperature rate settles, show nothing; use longer recordings");
  }
  Foretelling::OfPart before = before_.of(folds.parts.front());
  Foretelling::OfPart after = after_.of(folds.parts.front());
  for (std::size_t i = 1; i < folds.parts.size(); ++i) {
    before.join(before_.of(folds.parts[i]));
    after.join(after_.of(folds.parts[i]));
  }
  OutOfSample result;
  result.how = folds.how;
  result.within_runs = folds.within;
  result.promise = after.promise;
  result.score = judge::score(rows_.drift_dph, before.rows, after.rows);
  result.score.gain -= after_.log_choices() - before_.log_choices();
  const Eigen::VectorXd counted =
      noise::counted_weights(rows_, (before.rows.variance.array() > 0).select(weights_, 0));
  // A bias that was left out is no error of a model that gives each range its own.
  const auto rms = [&](const Eigen::VectorXd& residual, const series::Rows& biases) {
    const bool own = has_own_biases(biases, run_offsets_);
    return typical_rms(own ? biases.about_biases(residual, counted) : residual, counted,
                       folds.parts);
  };
  result.rms_before_dph = rms(before.residual_dph, biases_before_);
  result.rms_after_dph = rms(after.residual_dph, biases_after_);
  return result;
}

OutOfSample CrossValidation::on(const FarPart& far) const {
  return on(Folds{{far.part}, "on " + far.name + ", foretold from the rest", true});
}

OutOfSample CrossValidation::on_rows_from(std::size_t first) const {
  return on(Folds{{{{first, static_cast<std::size_t>(rows_.size())}}}, "", false});
}

OutOfSample CrossValidation::on_runs_or_stretches() const {
  const bool are_enough = rows_.runs().size() >= rules::kEnoughRuns;
  return on(are_enough ? runs_in_turn(rows_) : stretches_in_turn(rows_));
}

OutOfSample cross_validate_learner(const series::Rows& rows, const Eigen::VectorXd& residual_dph,
                                   const JudgedWith& with, const Learner& learner) {
  const Folds folds = stretches_in_turn(rows);
  Eigen::VectorXd after = residual_dph;
  for (const Part& part : folds.parts) {
    Eigen::VectorXd weights = with.row_weights;
    for (const recording::RowRange& range : part) series::of_rows(weights, range).setZero();
    const Eigen::VectorXd learnt = learner(weights);
    for (const recording::RowRange& range : part)
      series::of_rows(after, range) -= series::of_rows(learnt, range);
  }
  OutOfSample result = judge_residuals(rows, residual_dph, after, with.noise, with.row_weights);
  result.how = folds.how;
  result.within_runs = true;
  return result;
}

bool helps(const OutOfSample& judged) {
  return judged.rms_after_dph <= judged.rms_before_dph && judged.score.improves();
}

bool harms(const OutOfSample& judged) {
  return judged.rms_after_dph > judged.rms_before_dph && !judged.score.improves() &&
         judged.promise.is_broken();
}

std::string gain_words(const judge::Score& score) {
  return format("gain %.1f +- %.1f, needed %.1f", score.gain, score.standard_error, judge::kGain);
}

std::string out_of_sample_words(const OutOfSample& judged) {
  return format("%s -> %s deg/h %s (%s)", rounded(judged.rms_before_dph).c_str(),
                rounded(judged.rms_after_dph).c_str(), judged.how.c_str(),
                gain_words(judged.score).c_str());
}

OutOfSample judge_residuals(const series::Rows& rows, const Eigen::VectorXd& before,
                            const Eigen::VectorXd& after, const noise::NoiseModel& noise,
                            const Eigen::VectorXd& weights) {
  OutOfSample result;
  const Eigen::VectorXd counted = noise::counted_weights(rows, weights);
  result.rms_before_dph = weighted_rms(before, counted);
  result.rms_after_dph = weighted_rms(after, counted);
  const noise::Whitening whitening(noise, rows, weights);
  result.score =
      judge::score(Eigen::VectorXd::Zero(rows.size()), foretold(whitening, before, weights),
                   foretold(whitening, after, weights));
  return result;
}

OutOfSample judge_on_holdouts(const model::Model& before, const model::Model& after,
                              const std::vector<runs::Run>& holdouts,
                              const noise::NoiseModel& noise, bool run_offsets) {
  const series::SignalSeries series = runs::series_of(after, holdouts);
  const series::Rows& rows = series.rows();
  OutOfSample result = judge_residuals(rows, residual_on(before, holdouts, run_offsets),
                                       residual_on(after, holdouts, run_offsets), noise,
                                       rows.weights.cwiseProduct(noise::counted_rows(rows)));
  result.how =
      holdouts.size() == 1 ? "on the holdout" : "on " + counted(holdouts.size(), "holdout");
  return result;
}

}  // namespace fogcomp::fit
