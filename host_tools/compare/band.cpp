#include "compare/band.hpp"

#include <algorithm>
#include <cmath>

#include "compare/comparison.hpp"
#include "series/drift_uncertainty.hpp"
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

}  // namespace fogcomp::compare
