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

}  // namespace fogcomp::compare
