#include "fit/out_of_sample.hpp"

#include <algorithm>

#include "compare/comparison.hpp"
#include "fit/decision_rules.hpp"
#include "noise/autocorrelation.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/whitening.hpp"
#include "support/least_squares.hpp"
#include "support/median.hpp"
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

}  // namespace

std::string out_of_sample_words(const OutOfSample& judged) {
  const bool falls = judged.rms_after_dph < judged.rms_before_dph;
  const char* but = "";
  if (judged.chi2_drop >= rules::kMinChi2Drop && !judged.helps()) but = " without a rise";
  if (judged.chi2_drop < 0 && falls) but = ": weighed by its noise, slow noise included, it rises";
  return format("%s -> %s deg/h %s (gain %.1f, needed %g%s)",
                rounded(judged.rms_before_dph).c_str(), rounded(judged.rms_after_dph).c_str(),
                judged.how.c_str(), judged.chi2_drop, rules::kMinChi2Drop, but);
}

std::string harm_words(const OutOfSample& judged) {
  return format("it raises the error far from the rows fitted: %s -> %s deg/h %s (gain %.1f)",
                rounded(judged.rms_before_dph).c_str(), rounded(judged.rms_after_dph).c_str(),
                judged.how.c_str(), judged.chi2_drop);
}

bool OutOfSample::helps() const {
  return chi2_drop >= rules::kMinChi2Drop && rms_after_dph <= rms_before_dph;
}

bool OutOfSample::harms() const {
  return chi2_drop <= -rules::kMinChi2Drop;
}

OutOfSample judge_residuals(const series::Rows& rows, const Eigen::VectorXd& before,
                            const Eigen::VectorXd& after, const noise::NoiseModel& noise,
                            const Eigen::VectorXd& weights) {
  OutOfSample result;
  const Eigen::VectorXd counted = noise::counted_weights(rows, weights);
  result.rms_before_dph = weighted_rms(before, counted);
  result.rms_after_dph = weighted_rms(after, counted);
  const noise::Whitening whitening(noise, rows, weights);
  Eigen::VectorXd white_before = whitening.apply(before);
  Eigen::VectorXd white_after = whitening.apply(after);
  const double typical = sigma_by_median({white_before.begin(), white_before.end()});
  const double max = rules::kMaxCounted * std::max(1.0, typical);
  white_before = white_before.cwiseMax(-max).cwiseMin(max);
  white_after = white_after.cwiseMax(-max).cwiseMin(max);
  const double variance =
      std::max(1.0, white_after.squaredNorm() / static_cast<double>(rows.size()));
  const double together =
      noise::correlated_values({white_after.begin(), white_after.end()}, rows.runs());
  result.chi2_drop =
      (white_before.squaredNorm() - white_after.squaredNorm()) / (variance * together);
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
