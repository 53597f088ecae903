#include "refinement/fit_model.hpp"

#include <cmath>

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

}  // namespace

FitResult fit_model(Model& model, const SignalSeries& series, const FitSettings& settings) {
  const Rows& rows = series.rows();
  FitResult result;
  result.raw_std_dph = weighted_std(rows);
  model.network = RealNetwork();
  result.identified = identify(model, series, settings.identify);
  result.effects_rms_dph = model.residual_rms_dph;
  if (settings.training.hidden == 0) return result;

  Eigen::VectorXd target = result.identified.residual_dph;
  if (settings.row_denoising) denoise_rows(rows, *settings.row_denoising, target);
  const TrainingResult trained =
      train_levenberg_marquardt(rows.signals, target, rows.weights, settings.training);
  model.network = trained.network;
  model.residual_rms_dph = trained.rms_after_dph;
  result.effective_weights = trained.effective_parameters;
  return result;
}

}  // namespace fogcomp
