#include "planning/first_model.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "judge/prediction.hpp"
#include "planning/operating_box.hpp"
#include "planning/typical_gyro.hpp"
#include "support/decompositions.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::planning {
namespace {

constexpr double kBoxRow_s = 60;

Eigen::MatrixXd columns_of(const series::SignalSeries& series, const std::string& effects) {
  std::vector<Eigen::MatrixXd> columns;
  for (const model::EffectTerm& term : model::parse_effects(effects)) {
    columns.push_back(series.regressors(term));
  }
  return side_by_side(columns, series.rows().size());
}

series::SignalSeries series_of(const series::BlockSeries& blocks, double row_s,
                               double derivative_tau_s) {
  model::Model settings;
  settings.average_s = row_s;
  settings.derivative_tau_s = derivative_tau_s;
  series::SignalSeries series(settings, series::Phase::zero);
  series.add(blocks);
  return series;
}

// A model of the recording, in the box.
struct Fitted {
  double log_evidence = 0;    // but for what all have in common
  Eigen::VectorXd estimated;  // drift by least squares, as `fit` finds it
  Eigen::VectorXd expected;   // drift that the recording and the prior let expect
  double variance = 0;        // of that, summed over the rows
};

// Beforehand each column may do in the box as much as the whole drift did; the bias may be
// anything.
Fitted fitted(const Eigen::MatrixXd& columns, const Eigen::VectorXd& drift,
              const Eigen::MatrixXd& in_box, const WeightedRows& rows) {
  constexpr double kAny = 1e3;
  const double spread = std::sqrt((drift.array() - drift.mean()).square().mean());
  Eigen::VectorXd precision = in_box.colwise().squaredNorm().transpose() /
                              static_cast<double>(in_box.rows()) / (spread * spread);
  precision[0] /= kAny * kAny;
  const Eigen::MatrixXd own = rows.products(columns, columns);
  const Eigen::VectorXd towards = rows.products(columns, drift);
  Eigen::MatrixXd all = own;
  all.diagonal() += precision;
  const Eigen::MatrixXd covariance = inverse_of_definite(all);
  const Eigen::VectorXd mean = covariance * towards;
  return {(towards.dot(mean) + precision.array().log().sum()) / 2 -
              cholesky_factor(all).diagonal().array().log().sum(),
          in_box * solve_semidefinite(own, towards), in_box * mean,
          covariance.cwiseProduct(in_box.transpose() * in_box).sum()};
}

// The last contains the others: what it leaves is the noise.
std::vector<std::string> first_models(const OperatingBox& box) {
  std::vector<std::string> all{model::kFirstEffects, "bias,bias_temperature:order=3",
                               "bias,bias_temperature:order=3,temperature_rate"};
  if (box.rate_dps > 0) {
    for (std::string& effects : all) effects += ",scale_factor";
  }
  return all;
}

// Each is right with the probability that its evidence gives it.
std::string of_least_error(const std::vector<std::string>& choice,
                           const series::SignalSeries& series, const judge::Rows& judged,
                           const judge::NoiseLevels& noise, const series::SignalSeries& box) {
  const WeightedRows rows(judged.stretches, judged.row_s, noise);
  const Eigen::VectorXd drift = bridged(judged, judged.drift_dph);
  std::vector<Fitted> models;
  double most = -HUGE_VAL;
  for (const std::string& effects : choice) {
    models.push_back(fitted(bridged(judged, columns_of(series, effects)), drift,
                            columns_of(box, effects), rows));
    most = std::max(most, models.back().log_evidence);
  }
  std::vector<double> error;
  for (const Fitted& chosen : models) {
    double sum = 0;
    for (const Fitted& right : models) {
      sum += std::exp(right.log_evidence - most) *
             std::sqrt((chosen.estimated - right.expected).squaredNorm() + right.variance);
    }
    error.push_back(sum);
  }
  return choice[static_cast<std::size_t>(std::min_element(error.begin(), error.end()) -
                                         error.begin())];
}

}  // namespace

Prospect prospect_of(const series::BlockSeries& recording, double row_s, double derivative_tau_s) {
  const series::SignalSeries series = series_of(recording, row_s, derivative_tau_s);
  const series::Rows& rows = series.rows();
  const OperatingBox box = box_of_rows(rows);
  const std::vector<std::string> choice = first_models(box);
  const judge::Rows judged = rows_with(series, columns_of(series, choice.back()));
  const judge::NoiseLevels noise = judge::Prediction(judged).noise();
  Prospect prospect;
  if (box.temperature_degc.min < box.temperature_degc.max) {
    prospect.first_effects = of_least_error(
        choice, series, judged, noise,
        series_of(series::with_exact_temperature(series::make_blocks(typical_day(box, kBoxRow_s))),
                  kBoxRow_s, derivative_tau_s));
  }
  std::vector<model::EffectTerm> terms = model::parse_effects(prospect.first_effects);
  for (model::EffectTerm& term : terms) term = model::of_typical_size(term);
  prospect.visible =
      Information(series, terms, noise, rows.size()).visible_of_catalogue(recording.inputs);
  return prospect;
}

}  // namespace fogcomp::planning
