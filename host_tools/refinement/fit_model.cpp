#include "refinement/fit_model.hpp"

#include <cmath>
#include <utility>

#include "identification/independent_rows.hpp"
#include "wavelet/denoise_parts.hpp"

namespace fogcomp {
namespace {

double weighted_std(const Rows& rows) {
  const double mean = rows.drift_dph.dot(rows.weights) / rows.weights.sum();
  const Eigen::ArrayXd deviation = rows.drift_dph.array() - mean;
  return std::sqrt((deviation.square() * rows.weights.array()).sum() / rows.weights.sum());
}

// What the network is trained on, without its noise, as the reference paper does it. Rows further
// apart than one and a half times their length are not neighbours.
void denoise_rows(const Rows& rows, const DenoiseMethod& method, Eigen::VectorXd& values) {
  std::vector<fog::Span<double>> parts;
  std::size_t next_run = 0;
  for (std::size_t row = 0; row < rows.time_s.size(); ++row) {
    const bool new_run = next_run < rows.run_starts.size() && rows.run_starts[next_run] == row;
    if (new_run) ++next_run;
    if (new_run || rows.time_s[row] - rows.time_s[row - 1] > 1.5 * rows.row_s) {
      parts.push_back({values.data() + row, 0});
    }
    ++parts.back().size;
  }
  denoise_parts(parts, method, "--denoise-rows");
}

// The network learns what the effects leave from temperature and temperature rate.
NetworkTask network_task(const Rows& rows, Eigen::VectorXd target) {
  NetworkTask task;
  task.inputs.resize(rows.size(), 2);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    const auto& signals = rows.signals[static_cast<std::size_t>(i)];
    task.inputs.row(i) << signals.temperature, signals.temperature_rate;
  }
  task.target_dph = std::move(target);
  task.weights = rows.weights;
  task.run_starts = rows.run_starts;
  return task;
}

RealNetwork as_model(const TrainedNetwork& trained) {
  RealNetwork network;
  network.inputs = {
      {fog::NetworkInput::temperature, trained.inputs[0].centre, trained.inputs[0].half_range},
      {fog::NetworkInput::temperature_rate, trained.inputs[1].centre,
       trained.inputs[1].half_range}};
  network.hidden = trained.hidden;
  network.output = trained.output;
  network.centre_dph = trained.centre_dph;
  network.amplitude_dph = trained.amplitude_dph;
  return network;
}

}  // namespace

FitResult fit_model(Model& model, const SignalSeries& series, const FitSettings& settings) {
  const Rows& rows = series.rows();
  FitResult result;
  result.raw_std_dph = weighted_std(rows);
  model.network = RealNetwork();
  result.identified = identify(model, series, settings.identify);
  result.effects_rms_dph = model.residual_rms_dph;
  if (settings.network.hidden == 0) return result;

  Eigen::VectorXd target = result.identified.residual_dph;
  if (settings.row_denoising) denoise_rows(rows, *settings.row_denoising, target);
  NetworkSettings network = settings.network;
  network.training.independent_share = independent_share(result.identified.noise);
  const TrainedNetwork trained = train_network(network_task(rows, std::move(target)), network);
  model.network = as_model(trained);
  model.residual_rms_dph = trained.rms_after_dph;
  result.training = trained.result;
  return result;
}

}  // namespace fogcomp
