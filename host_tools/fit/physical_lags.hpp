#pragma once

#include <string>
#include <vector>

#include "compare/run_in_blocks.hpp"
#include "model/model.hpp"

namespace fogcomp::fit {

/// A time constant of the gyro itself.
struct PhysicalLag {
  std::string effect;
  std::string parameter;
  double value_s = 0;
  double sigma_s = 0;  ///< one standard deviation
};

/// The identified time constants of a fitted model that act on the temperature rate. In the model
/// they stand behind the board's derivative, which is itself late by two lags and a block, and make
/// up for that: a coil's lag of 300 s becomes some 190 s. Here they are identified again, from
/// where the fit found them, on signals without that delay. None where the data do not determine
/// them so.
std::vector<PhysicalLag> physical_lags(const model::Model& model,
                                       const std::vector<compare::RunInBlocks>& runs,
                                       bool run_offsets);

/// "shupe   tau without the lags of the board's derivative, the gyro's own: 301 +- 4 s".
std::string physical_lag_words(const PhysicalLag& lag);

}  // namespace fogcomp::fit
