#include "diagnosis/model_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnosis/decision_rules.hpp"
#include "diagnosis/structure.hpp"
#include "model/catalogue.hpp"
#include "noise/input_rate.hpp"
#include "noise/outlier_rows.hpp"
#include "noise/quiet_rows.hpp"
#include "noise/whitening.hpp"
#include "support/input_error.hpp"
#include "support/least_squares.hpp"
#include "support/text.hpp"

namespace fogcomp::diagnosis {
namespace {

// With too few quiet rows for the slow noise, the high-pass part of the other rows is used: the
// residual of smooth functions of any kind.
noise::NoiseModel noise_with_less_quiet(const series::Rows& rows,
                                        const fit::NoiseWeightedFit& fit) {
  // Smooth functions cover up to 8 periods per run and remove some noise beyond. Without any quiet
  // part a low estimate is better than one that takes all drift for noise.
  const std::size_t first_frequency = fit.noise.from_quiet_parts ? 16 : 8;
  std::vector<Eigen::MatrixXd> parts{fit.columns};
  for (StructureGroup& group : structure_groups(rows)) parts.push_back(std::move(group.columns));
  parts.push_back(noise::input_rate_columns(rows));
  const LinearFit smooth = solve_linear(side_by_side(parts, rows.size()), rows.drift_dph);
  const Eigen::VectorXd rest = noise::bridged(rows, smooth.residual, fit.robust);
  const Eigen::VectorXd residual = noise::bridged(
      rows, noise::without_input_rate(rows, fit.residual_dph, fit.robust), fit.robust);
  std::vector<noise::NoiseSample> samples =
      noise::noise_samples(noise::quiet_stretches(rows, residual));
  for (const recording::RowRange& run : rows.runs()) {
    samples.push_back({series::of_rows(rest, run), first_frequency});
  }
  noise::NoiseModel noise = noise::fit_noise(samples, rows.row_s, rows.longest_run_s());
  noise.from_quiet_parts = fit.noise.from_quiet_parts;
  return noise;
}

}  // namespace

fit::NoiseWeightedFit fit_for_diagnosis(const model::Model& model, const DiagnosisData& data,
                                        const std::optional<noise::NoiseModel>& noise) {
  const series::Rows& rows = data.series().rows();
  if (rows.size() < rules::kMinRows) {
    throw InputError("diagnose",
                     format("%s of %g s: too few; at least %td are needed: "
                            "fogcomp add judges one effect of few rows; more rows come of a longer "
                            "recording, a shorter --average, or a --table of more means",
                            counted(static_cast<std::size_t>(rows.size()), "row").c_str(),
                            rows.row_s, rules::kMinRows));
  }
  const Eigen::MatrixXd offsets = fit::run_offset_columns(rows);
  fit::NoiseWeightedFit fit =
      fit::fit_rows(data.series(), data.series().acting(model.terms), offsets, {{}, noise});
  if (noise || fit.noise.degrees_of_freedom >= rules::kEnoughFreedom) return fit;
  return fit::fit_rows(data.series(), fit.terms, offsets,
                       {{}, noise_with_less_quiet(rows, fit), true});
}

double rms_of_rows(const series::Rows& rows, const fit::NoiseWeightedFit& fit,
                   const Eigen::VectorXd& residual) {
  const Eigen::VectorXd weights = noise::counted_weights(rows, fit.row_weights);
  return std::sqrt(residual.cwiseAbs2().dot(weights) / weights.sum());
}

std::vector<model::EffectTerm> with_term(std::vector<model::EffectTerm> terms,
                                         const model::EffectTerm& added) {
  const auto same = [&](const model::EffectTerm& term) { return term.name == added.name; };
  if (!model::is_event(added)) {
    terms.erase(std::remove_if(terms.begin(), terms.end(), same), terms.end());
  }
  terms.push_back(added);
  return terms;
}

Refit refit(std::vector<model::EffectTerm> terms, const series::SignalSeries& series,
            const fit::NoiseWeightedFit& fit) {
  const series::Rows& rows = series.rows();
  std::vector<Eigen::MatrixXd> parts;
  for (const model::EffectTerm& term : terms) parts.push_back(series.regressors(term));
  parts.push_back(fit::run_offset_columns(rows));
  const Eigen::MatrixXd columns = side_by_side(parts, rows.size());
  const noise::Whitening whitening(fit.noise, rows, fit.row_weights);
  const LinearFit solved = solve_linear(whitening.apply(columns), fit.whitened_measured);
  Eigen::Index first = 0;
  for (std::size_t i = 0; i < terms.size(); ++i) {
    terms[i].set_coefficients(solved.coefficients.segment(first, parts[i].cols()));
    first += parts[i].cols();
  }
  return {std::move(terms), rows.drift_dph - columns * solved.coefficients};
}

}  // namespace fogcomp::diagnosis
