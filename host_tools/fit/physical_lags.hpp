#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "runs/run.hpp"

namespace fogcomp::fit {

/// A time constant of the gyro itself, without the delay of the board's derivative.
struct PhysicalLag {
  std::string effect;
  std::string parameter;
  double value_s = 0;
  double sigma_s = 0;  ///< one standard deviation
};

/// The identified time constants of a fitted model that act on the temperature rate. In the model
/// they follow the board's derivative, which has a delay of two lags and a block, and compensate
/// for it: a coil's lag of 300 s becomes about 190 s. Here they are identified again on signals
/// without that delay, starting from the fitted values. Empty if the data do not determine them.
std::vector<PhysicalLag> physical_lags(const model::Model& model,
                                       const std::vector<runs::Run>& runs, bool run_offsets);

/// "shupe   tau without the lags of the board's derivative, the gyro's own: 301 +- 4 s".
std::string physical_lag_words(const PhysicalLag& lag);

}  // namespace fogcomp::fit
