#include "fit/fit_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "denoise/denoise_parts.hpp"
#include "noise/outlier_rows.hpp"

namespace fogcomp::fit {
namespace {

// Standard deviation with n - 1 in the denominator.
double weighted_std(const Eigen::VectorXd& values, const Eigen::VectorXd& weights) {
  const Eigen::ArrayXd deviation = values.array() - values.dot(weights) / weights.sum();
  return std::sqrt((deviation.square() * weights.array()).sum() / std::max(weights.sum() - 1, 1.0));
}

// Removes noise from the target of the network, as the reference paper does.
void denoise_rows(const series::Rows& rows, const denoise::DenoiseMethod& method,
                  Eigen::VectorXd& values) {
  std::vector<fog::Span<double>> parts;
  for (const recording::RowRange& stretch : rows.stretches()) {
    parts.push_back({values.data() + stretch.first, stretch.size()});
  }
  denoise::denoise_parts(parts, method, "--denoise-rows");
}

model::RealNetwork as_model(const network::TrainedNetwork& trained,
                            std::vector<model::RealInput> inputs) {
  model::RealNetwork network;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i].centre = trained.inputs[i].centre;
    inputs[i].half_range = trained.inputs[i].half_range;
  }
  network.inputs = std::move(inputs);
  network.hidden = trained.hidden;
  network.output = trained.output;
  network.centre_dph = trained.centre_dph;
  network.amplitude_dph = trained.amplitude_dph;
  return network;
}

}  // namespace

FitResult fit_effects(model::Model& model, const KnownRegressors& known,
                      const IdentifySettings& settings) {
  const series::Rows& rows = known.series().rows();
  FitResult result;
  model.network = model::RealNetwork();
  result.identified = identify(model, known, settings);
  result.raw_std_dph =
      weighted_std(rows.drift_dph, noise::counted_weights(rows, result.identified.row_weights));
  result.effects_rms_dph = model.residual_rms_dph;
  return result;
}

void fit_network(model::Model& model, const KnownRegressors& known, const FitSettings& settings,
                 FitResult& result) {
  if (settings.network.hidden == 0) return;
  const series::SignalSeries& series = known.series();
  const series::Rows& rows = series.rows();
  Eigen::VectorXd target = result.identified.residual_dph;
  if (settings.row_denoising) denoise_rows(rows, *settings.row_denoising, target);
  const ResidualNetwork network =
      train_on_residual(rows, series.network_inputs(settings.network_inputs), target,
                        result.identified, settings.network, !settings.force_network);
  result.training = network.trained.result;
  result.network_judged = network.judged;
  if (!network.worth_keeping()) return;
  model.network = as_model(network.trained, settings.network_inputs);
  model.residual_rms_dph = network.trained.rms_after_dph;
}

FitResult fit_model(model::Model& model, const KnownRegressors& known,
                    const FitSettings& settings) {
  FitResult result = fit_effects(model, known, settings.identify);
  fit_network(model, known, settings, result);
  return result;
}

}  // namespace fogcomp::fit
