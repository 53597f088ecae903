#include "compare/model_on_runs.hpp"

#include <algorithm>
#include <utility>

#include "noise/noise_floor.hpp"
#include "support/text.hpp"

namespace fogcomp::compare {

ModelOnRun try_model(const model::Model& model, const runs::Run& run, double row_s) {
  Comparison comparison = compare_with(model, run, row_s);
  ResidualAnalysis analysis = analyse_residual(comparison);
  const BoardError error = board_error(model, run, comparison);
  return {std::move(comparison), std::move(analysis), error, band_of(model, run)};
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

}  // namespace fogcomp::compare
