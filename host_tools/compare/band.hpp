#pragma once

#include <optional>
#include <vector>

#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::compare {

/// What a model promises of a run that it was not fitted to, and whether it holds: means over ten
/// minutes, by which white noise is small beside the drift.
struct PredictiveBand {
  double row_s = 0;
  std::vector<double> time_s;
  std::vector<double> residual_dph;  ///< measured less modelled, as the board computes it
  std::vector<double> sigma_dph;     ///< one standard deviation promised

  /// Fraction of the means within so many standard deviations: 0.68 within 1, 0.95 within 2.
  double share_within(double sigmas) const;
};

/// The standard deviation is that of the drift (series/drift_uncertainty.hpp) and of the noise:
/// white, flicker over the run, a random walk since its start, and the bias of another power-on.
/// Nothing if the model does not know its uncertainty, or the run is shorter than two means.
std::optional<PredictiveBand> band_of(const model::Model& model, const runs::Run& run);

}  // namespace fogcomp::compare
