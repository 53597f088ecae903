#include "refinement/fit_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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
  for (std::size_t row = 0; row < rows.time_s.size(); ++row) {
    if (rows.starts_run(row) || rows.time_s[row] - rows.time_s[row - 1] > 1.5 * rows.row_s) {
      parts.push_back({values.data() + row, 0});
    }
    ++parts.back().size;
  }
  denoise_parts(parts, method, "--denoise-rows");
}

RealNetwork as_model(const TrainedNetwork& trained, std::vector<RealInput> inputs) {
  RealNetwork network;
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

double delay_error_dph(const Model& model, const std::vector<RunInBlocks>& runs) {
  double square = 0;
  double weight = 0;
  // Run by run: after a start or a gap the two have different rows, which are matched by their
  // time.
  for (const RunInBlocks& run : runs) {
    SignalSeries board(model);
    SignalSeries coil(model, Phase::zero);
    board.add(run.blocks);
    coil.add(run.blocks);
    const Eigen::VectorXd late = board.drift_dph(model.terms);
    const Eigen::VectorXd exact = coil.drift_dph(model.terms);
    const Rows& rows = board.rows();
    Eigen::Index at = 0;
    for (Eigen::Index row = 0; row < rows.size(); ++row) {
      const double time_s = rows.time_s[static_cast<std::size_t>(row)];
      while (at + 1 < exact.size() &&
             coil.rows().time_s[static_cast<std::size_t>(at)] < time_s - rows.row_s / 2) {
        ++at;
      }
      square += rows.weights[row] * std::pow(late[row] - exact[at], 2);
      weight += rows.weights[row];
    }
  }
  return std::sqrt(square / std::max(weight, 1e-300));
}

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
  const ResidualNetwork network =
      train_on_residual(rows, series.network_inputs(settings.network_inputs), target,
                        result.identified, settings.network, !settings.force_network);
  result.training = network.trained.result;
  result.network_judged = network.judged;
  if (!network.worth_keeping()) return result;
  model.network = as_model(network.trained, settings.network_inputs);
  model.residual_rms_dph = network.trained.rms_after_dph;
  return result;
}

}  // namespace fogcomp
