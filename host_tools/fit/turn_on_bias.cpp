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

// Mean square of the fitted drift, without the mean of each run.
double drift_square(const series::Rows& rows, const NoiseWeightedFit& fit) {
  const Eigen::VectorXd described = fit.columns * fit.coefficients;
  double square = 0;
  for (const recording::RowRange& run : rows.runs()) {
    const auto of_run = series::of_rows(described, run);
    square += (of_run.array() - of_run.mean()).square().sum();
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
  if (runs.size() < 2) return found;
  series::SignalSeries series(model);
  for (const compare::RunInBlocks& run : runs) {
    if (model.network.present()) {
      series.add(without_network(model, run.blocks));
    } else {
      series.add(run.blocks);
    }
  }
  const Eigen::MatrixXd offsets = run_offset_columns(series.rows());
  const NoiseWeightedFit fit =
      fit_rows(series, model::with_fixed_shapes(series.acting(model.terms)), offsets);
  if (series.rows().size() <= fit.linear() || !is_determined(fit)) return found;
  const Eigen::MatrixXd covariance = coefficient_covariance(series.rows(), fit);
  const double of_form = rules::kModelFormTolerance * drift_square(series.rows(), fit);
  const Eigen::Index first = fit.linear() - offsets.cols();
  for (std::size_t run = 1; run < runs.size(); ++run) {
    const Eigen::Index column = first + static_cast<Eigen::Index>(run) - 1;
    const double above_dph = fit.coefficients[column];
    const double sigma_dph = std::sqrt(covariance(column, column) + of_form);
    found.push_back({runs[run].file, runs[0].file, above_dph, sigma_dph,
                     is_certain(above_dph / sigma_dph, runs.size() - 1)});
  }
  return found;
}

}  // namespace fogcomp::fit
