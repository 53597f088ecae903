#include "fit/turn_on_bias.hpp"

#include <cmath>
#include <optional>

#include "fit/coefficient_covariance.hpp"
#include "fit/decision_rules.hpp"
#include "fit/noise_weighted_fit.hpp"
#include "fit/undetermined.hpp"
#include "model/drift_model.hpp"
#include "model/shape_parameter.hpp"
#include "series/block_walk.hpp"

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
  for (const recording::RowRange& power_on : rows.power_ons()) {
    const auto part = series::of_rows(described, power_on);
    square += (part.array() - part.mean()).square().sum();
  }
  return square / static_cast<double>(rows.size());
}

// Whether a difference is larger than the one that so many equal runs show with probability
// rules::kFalseTurnOn.
bool is_certain(double standard_deviations, std::size_t differences) {
  const double chance = std::erfc(std::abs(standard_deviations) / std::sqrt(2.0));
  return chance * static_cast<double>(differences) < rules::kFalseTurnOn;
}

}  // namespace

std::vector<compare::TurnOnBias> turn_on_biases(const model::Model& model,
                                                const std::vector<compare::RunInBlocks>& runs) {
  std::vector<compare::TurnOnBias> found;
  if (!compare::have_several_power_ons(runs)) return found;
  series::SignalSeries series(model);
  for (const compare::RunInBlocks& run : runs) {
    if (model.network.present()) {
      series.add(without_network(model, run.blocks));
    } else {
      series.add(run.blocks);
    }
  }
  const series::Rows& rows = series.rows();
  const std::vector<recording::RowRange> power_ons = rows.power_ons();
  if (power_ons.size() < 2) return found;
  const Eigen::MatrixXd offsets = run_offset_columns(rows);
  const NoiseWeightedFit fit =
      fit_rows(series, model::with_fixed_shapes(series.acting(model.terms)), offsets);
  if (rows.size() <= fit.linear() || !is_determined(fit)) return found;
  const Eigen::MatrixXd covariance = coefficient_covariance(rows, fit);
  const double of_form = rules::kModelFormTolerance * drift_square(rows, fit);
  const Eigen::Index first = fit.linear() - offsets.cols();
  for (std::size_t i = 1; i < power_ons.size(); ++i) {
    const Eigen::Index column = first + static_cast<Eigen::Index>(i) - 1;
    const double above_dph = fit.coefficients[column];
    const double sigma_dph = std::sqrt(covariance(column, column) + of_form);
    const std::size_t row = power_ons[i].first;
    found.push_back({runs[rows.run_at(row)].file, rows.starts_run(row) ? 0 : rows.time_s[row],
                     runs[0].file, above_dph, sigma_dph,
                     is_certain(above_dph / sigma_dph, power_ons.size() - 1)});
  }
  return found;
}

std::optional<compare::TurnOnBias> certain_turn_on(const model::Model& model,
                                                   const std::vector<compare::RunInBlocks>& runs) {
  for (const compare::TurnOnBias& bias : turn_on_biases(model, runs)) {
    if (bias.certain) return bias;
  }
  return std::nullopt;
}

}  // namespace fogcomp::fit
