#pragma once

#include <cstdint>
#include <vector>

#include "core/thermal/signals.hpp"
#include "model/network.hpp"

namespace fogcomp {

struct TrainingSettings {
  int hidden = 10;         ///< neurons, 1 to 32
  std::uint64_t seed = 1;  ///< of the initial weights
  int most_steps = 200;
};

struct TrainingResult {
  RealNetwork network;
  double rms_before_dph = 0;
  double rms_after_dph = 0;
  double effective_parameters =
      0;  ///< of the weights, how many the data determine (MacKay's gamma)
  int steps = 0;
};

/// Trains inputs(temperature, temperature rate) -> logsig hidden -> tansig output on `target_dph`,
/// what the effects leave, a value per row of `signals`. Levenberg-Marquardt on beta * sum e^2 +
/// alpha * sum w^2, with alpha and beta re-estimated after every step by MacKay's evidence rules
/// (Foresee & Hagan, ICNN 1997), so that a network with nothing to learn shrinks to nothing instead
/// of learning noise.
TrainingResult train_levenberg_marquardt(const std::vector<fog::Signals<RealNumbers>>& signals,
                                         const Eigen::VectorXd& target_dph,
                                         const Eigen::VectorXd& weights,
                                         const TrainingSettings& settings);

}  // namespace fogcomp
