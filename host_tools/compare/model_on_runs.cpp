#include "compare/model_on_runs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/comparison.hpp"
#include "compare/decision_rules.hpp"
#include "noise/noise_floor.hpp"
#include "series/signal_series.hpp"
#include "support/text.hpp"
#include "support/units.hpp"

namespace fogcomp::compare {
namespace {

constexpr double kMean_s = 600;

// Variance of a mean over `row_s`, at a time since the start of a run of `run_s`.
double noise_variance(const model::Model& model, double row_s, double run_s, double since_start_s) {
  const model::Model::Uncertainty& known = *model.uncertainty;
  const double white = std::pow(known.white_dph, 2) * model.average_s / row_s;
  // Density B^2 / (pi f) between the run's length and the row's.
  const double flicker =
      std::pow(known.flicker_dph, 2) / kPi * (1 + std::log(std::max(1.0, run_s / row_s)));
  const double walk = std::pow(known.walk_dph_per_rth, 2) * since_start_s / kSecondsPerHour;
  return white + flicker + walk + std::pow(known.turn_on_dph, 2);
}

struct Delay {
  Eigen::VectorXd drift_dph;  // per row: as the board computes it, less the gyro's own
  Eigen::VectorXd weights;
};

Delay delay_of(const model::Model& model, const runs::Run& run) {
  series::SignalSeries series(model);
  series.add(run.blocks);
  return {series.drift_dph(model.terms) - series.drift_dph(model.terms, series::Reading::of_gyro),
          series.rows().weights};
}

}  // namespace

double PredictiveBand::share_within(double sigmas) const {
  double within = 0;
  for (std::size_t i = 0; i < residual_dph.size(); ++i)
    within += std::abs(residual_dph[i]) <= sigmas * sigma_dph[i] ? 1 : 0;
  return within / static_cast<double>(residual_dph.size());
}

std::optional<PredictiveBand> band_of(const model::Model& model, const runs::Run& run) {
  if (!model.uncertainty) return std::nullopt;
  const Comparison comparison = compare_with(model, run, kMean_s);
  const series::Rows& rows = comparison.rows;
  if (rows.size() < 2) return std::nullopt;
  model::Model averaging = model;
  averaging.average_s = kMean_s;
  series::SignalSeries series(averaging);
  series.add(run.blocks);
  const Eigen::VectorXd of_drift = series::drift_sigma_dph(model, series);
  PredictiveBand band;
  band.row_s = rows.row_s;
  const std::vector<double> residuals = comparison.residuals_dph();
  const double run_s = rows.time_s.back() - rows.time_s.front();
  for (std::size_t i = 0; i < comparison.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    if (comparison.outlier[i] || rows.weights[row] < 0.5) continue;  // a part of a mean
    band.time_s.push_back(rows.time_s[i]);
    band.residual_dph.push_back(residuals[i]);
    const double noise =
        noise_variance(model, rows.row_s, run_s, rows.time_s[i] - rows.time_s.front());
    band.sigma_dph.push_back(std::sqrt(std::pow(of_drift[row], 2) + noise));
  }
  if (band.time_s.size() < 2) return std::nullopt;
  return band;
}

ModelOnRun try_model(const model::Model& model, const runs::Run& run, double row_s) {
  Comparison comparison = compare_with(model, run, row_s);
  ResidualAnalysis analysis = analyse_residual(comparison);
  const BoardError error = board_error(model, run, comparison);
  return {std::move(comparison), std::move(analysis), error, band_of(model, run)};
}

const ModelOnRun& ModelOnRuns::worst() const {
  const auto drift_dph = [](const ModelOnRun& run) {
    return floor_removed(run.comparison.whole.rms_dph, run.comparison.noise_floor_dph.value_or(0));
  };
  return *std::max_element(runs.begin(), runs.end(), [&](const ModelOnRun& a, const ModelOnRun& b) {
    return drift_dph(a) < drift_dph(b);
  });
}

double ModelOnRuns::extrapolated_fraction() const {
  double outside = 0;
  double rows = 0;
  for (const ModelOnRun& run : runs) {
    const auto run_rows = static_cast<double>(run.comparison.size());
    outside += run.comparison.outside.temperature * run_rows;
    rows += run_rows;
  }
  return rows > 0 ? outside / rows : 0;
}

std::vector<const ModelOnRuns*> best_first(const std::vector<ModelOnRuns>& models) {
  std::vector<const ModelOnRuns*> order;
  for (const ModelOnRuns& model : models) order.push_back(&model);
  const auto best = std::min_element(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return a->worst().comparison.whole.rms_dph < b->worst().comparison.whole.rms_dph;
  });
  std::rotate(order.begin(), best, best + 1);
  return order;
}

bool is_below_floor(const Comparison& comparison) {
  const double rms_dph = comparison.whole.rms_dph;
  const double uncertainty = floor_uncertainty(comparison.size() - comparison.outliers);
  return comparison.noise_floor_dph && rms_dph < *comparison.noise_floor_dph * (1 - uncertainty);
}

std::string TurnOnBias::from_words() const {
  return from_s == 0 ? "" : format(" from %.6g s on", from_s);
}

const TurnOnBias* TurnOn::first_certain() const {
  const auto bias =
      std::find_if(biases.begin(), biases.end(), [](const TurnOnBias& one) { return one.certain; });
  return bias == biases.end() ? nullptr : &*bias;
}

std::string TurnOn::differs_words() const {
  return format(
      "from power-on to power-on the bias differs by %.2g deg/h (one sigma) beside this model",
      repeatability_dph);
}

std::string TurnOn::doubt_words() const {
  return differs_words() +
         ": turn-on biases, noise slower than a recording, or a drift that it lacks; each "
         "temperature in two of the recordings, or one recording over all of them, would tell";
}

void BoardError::add(const BoardError& other) {
  const auto pooled = [&](double own, double others) {
    const double square = rows * own * own + other.rows * others * others;
    return std::sqrt(square / std::max(rows + other.rows, 1e-300));
  };
  rms_dph = pooled(rms_dph, other.rms_dph);
  without_delay_dph = pooled(without_delay_dph, other.without_delay_dph);
  rows += other.rows;
}

bool BoardError::delay_matters() const {
  return rms_dph - without_delay_dph > rules::kTellsApart * rms_dph;
}

std::string delay_words(const BoardError& error) {
  return format(
      "as the board computes it, the model leaves %.4g deg/h rms; without the board's delay (block "
      "means, derivative filter) it would leave %.4g",
      error.rms_dph, error.without_delay_dph);
}

BoardError board_error(const model::Model& model, const runs::Run& run,
                       const Comparison& comparison) {
  model::Model averaging = model;
  averaging.average_s = comparison.rows.row_s;
  const Delay delay = delay_of(averaging, run);
  BoardError error{comparison.whole.rms_dph, 0, 0};
  double square = 0;
  const std::vector<double> residuals = comparison.residuals_dph();
  for (std::size_t i = 0; i < comparison.size(); ++i) {
    if (comparison.outlier[i]) continue;
    const auto row = static_cast<Eigen::Index>(i);
    const double weight = comparison.rows.weights[row];
    const double residual = residuals[i] + delay.drift_dph[row];
    square += weight * residual * residual;
    error.rows += weight;
  }
  error.without_delay_dph = std::sqrt(square / std::max(error.rows, 1e-300));
  return error;
}

}  // namespace fogcomp::compare
