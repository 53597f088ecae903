#pragma once

#include <vector>

#include "core/signal/quantities.hpp"
#include "core/thermal/block_means.hpp"

namespace fogcomp::board {

/// Blocks that exercise all states of a model: the whole temperature range up and down at 0.2 to 30
/// degC/min with soaks, jumps, and shrinking loops about a quarter, the middle and three quarters
/// of the range; every other input varies over its usual range with its own period; the second half
/// is years after power-on. Every value is exact in the board's formats, so that only the model is
/// compared.
std::vector<fog::BlockMeans<fog::BoardNumbers>> verification_programme(fog::Temperature min,
                                                                       fog::Temperature max,
                                                                       double block_s);

}  // namespace fogcomp::board
