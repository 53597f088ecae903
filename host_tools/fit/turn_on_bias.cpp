#include "fit/turn_on_bias.hpp"

#include <algorithm>
#include <cmath>

#include "fit/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/predict.hpp"
#include "fit/turn_on_repeatability.hpp"
#include "fit/undetermined.hpp"
#include "model/drift_model.hpp"
#include "model/shape_parameter.hpp"
#include "series/block_walk.hpp"
#include "support/evidence.hpp"
#include "support/least_squares.hpp"

namespace fogcomp::fit {
namespace {

// The blocks of a run less the drift of the network.
series::BlockSeries without_network(const model::Model& model, series::BlockSeries blocks) {
  model::RealDriftModel drift(model, blocks.block_s);
  std::vector<double> network_dph(blocks.blocks.size(), 0);
  series::run_blocks(blocks, drift, [&](const series::BlockSeries::Block& block) {
    network_dph[static_cast<std::size_t>(&block - blocks.blocks.data())] = drift.network_dph();
  });
  for (std::size_t i = 0; i < network_dph.size(); ++i) blocks.blocks[i].rate_dph -= network_dph[i];
  return blocks;
}

// Mean square of the fitted drift, without the mean of each power-on.
double drift_square(const series::Rows& rows, const NoiseWeightedFit& fit) {
  const Eigen::VectorXd described = fit.columns * fit.coefficients;
  double square = 0;
  for (const recording::RowRange& power_on : rows.bias_ranges()) {
    const auto part = series::of_rows(described, power_on);
    square += (part.array() - part.mean()).square().sum();
  }
  return square / static_cast<double>(rows.size());
}

// Bias of a power-on less that of the first.
struct Offset {
  double above_dph = 0;
  double sigma_dph = 0;
};

// Bias of the second, third... power-on less that of the first, the last columns of a fit.
struct Offsets {
  std::vector<Offset> each;
  Eigen::MatrixXd covariance;  // of all coefficients of the fit
};

// Nothing if the fit does not determine them. What formulas are off by is another bias for each.
Offsets offsets_of(const series::Rows& rows, const NoiseWeightedFit& fit, Eigen::Index count) {
  if (rows.size() <= fit.linear() || !is_determined(fit)) return {};
  Offsets offsets{{}, predict(rows, fit).covariance()};
  offsets.covariance.bottomRightCorner(count, count) +=
      rules::kModelFormTolerance * drift_square(rows, fit) / 2 * covariance_of_offsets(count);
  for (Eigen::Index i = fit.linear() - count; i < fit.linear(); ++i) {
    offsets.each.push_back({fit.coefficients[i], std::sqrt(offsets.covariance(i, i))});
  }
  return offsets;
}

// Which of them are larger than the one that so many equal runs show with probability kFalseAlarm.
std::vector<bool> certain_ones(const std::vector<Offset>& offsets) {
  std::vector<bool> certain;
  for (const Offset& offset : offsets) {
    const double standard_deviations = std::abs(offset.above_dph) / offset.sigma_dph;
    const double chance = std::erfc(standard_deviations / std::sqrt(2.0));
    certain.push_back(chance * static_cast<double>(offsets.size()) < kFalseAlarm);
  }
  return certain;
}

// The rows of the runs less the drift of the network.
series::SignalSeries rows_of_effects(const model::Model& model,
                                     const std::vector<runs::Run>& runs) {
  if (!model.network.present()) return runs::series_of(model, runs);
  series::SignalSeries series(model);
  for (const runs::Run& run : runs) series.add(without_network(model, run.blocks));
  return series;
}

// A smooth drift with temperature that these effects cannot make, whatever the model has of it:
// recordings at other temperatures are no proof that biases differ.
Eigen::MatrixXd smooth_drift(const series::Rows& rows, const Eigen::MatrixXd& effects) {
  constexpr Eigen::Index kOrder = 5;   // of a polynomial
  constexpr double kOwnLength = 1e-3;  // of a column's length: else the effects make it
  const std::vector<double> degc = rows.temperatures_degc();
  const auto [min, max] = std::minmax_element(degc.begin(), degc.end());
  const double range_degc = std::max(*max - *min, 1e-6);
  Eigen::MatrixXd chebyshev(rows.size(), kOrder);
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    const double x = 2 * (degc[static_cast<std::size_t>(row)] - *min) / range_degc - 1;
    const double angle = std::acos(std::clamp(x, -1.0, 1.0));
    for (Eigen::Index k = 0; k < kOrder; ++k)
      chebyshev(row, k) = std::cos(static_cast<double>(k + 1) * angle);
  }
  const Eigen::MatrixXd left = projected_out(orthonormal(effects), chebyshev);
  std::vector<Eigen::Index> own;
  for (Eigen::Index k = 0; k < kOrder; ++k) {
    if (left.col(k).norm() > kOwnLength * chebyshev.col(k).norm()) own.push_back(k);
  }
  return orthonormal(left(Eigen::all, own));
}

}  // namespace

compare::TurnOn turn_on_biases(const model::Model& model, const std::vector<runs::Run>& runs) {
  compare::TurnOn found;
  if (!runs::have_several_biases(runs)) return found;
  const series::SignalSeries series = rows_of_effects(model, runs);
  const series::Rows& rows = series.rows();
  const std::vector<recording::RowRange> power_ons = rows.bias_ranges();
  if (power_ons.size() < 2) return found;
  // A board's derivative begins at rest at each power-on: of a ramp that is a bias, too.
  const KnownRegressors known = KnownRegressors(series).of(series::Reading::of_gyro);
  std::vector<model::EffectTerm> terms = series.acting(model.terms);
  for (model::EffectTerm& term : terms) term = model::of_gyro(term);
  terms = model::with_fixed_shapes(std::move(terms));
  const Eigen::MatrixXd columns = run_offset_columns(rows);
  const NoiseWeightedFit fit = fit_rows(known, terms, columns);
  const Offsets offsets = offsets_of(rows, fit, columns.cols());
  const Eigen::Index effects = fit.linear() - columns.cols();
  const TurnOnRepeatability repeatability =
      turn_on_repeatability(fit, {effects, columns.cols()}, offsets.covariance);
  found.repeatability_dph = repeatability.dph;

  std::vector<bool> certain = certain_ones(offsets.each);
  const bool any = std::find(certain.begin(), certain.end(), true) != certain.end();
  found.differs = any || repeatability.chance < kFalseAlarm;
  if (any) {
    const Eigen::MatrixXd smooth = smooth_drift(rows, fit.columns.leftCols(effects));
    const std::vector<bool> too = certain_ones(
        offsets_of(rows, fit_rows(known, terms, side_by_side({smooth, columns}, rows.size())),
                   columns.cols())
            .each);
    for (std::size_t i = 0; i < certain.size(); ++i)
      certain[i] = certain[i] && !too.empty() && too[i];
  }
  for (std::size_t i = 0; i < offsets.each.size(); ++i) {
    const std::size_t row = power_ons[i + 1].first;
    found.biases.push_back({runs[rows.run_at(row)].file,
                            rows.starts_run(row) ? 0 : rows.time_s[row], runs[0].file,
                            offsets.each[i].above_dph, offsets.each[i].sigma_dph, certain[i]});
  }
  return found;
}

}  // namespace fogcomp::fit
