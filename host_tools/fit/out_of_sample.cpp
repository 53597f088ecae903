#include "fit/out_of_sample.hpp"

#include "compare/comparison.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::fit {
namespace {

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
