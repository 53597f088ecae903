#pragma once

#include <vector>

#include "core/signal/quantities.hpp"
#include "core/thermal/block_means.hpp"

namespace fogcomp::board {

/// Blocks that lead a model through all that it can remember: the whole temperature range up and
/// down at 0.2 to 30 degC/min with soaks, jumps, loops that shrink about a quarter, the middle and
/// three quarters of the range, while every other input goes through its usual range with a period
/// of its own; the second half years after power-on. Every value is one that the board can hold, so
/// that only the model is compared.
std::vector<fog::BlockMeans<fog::BoardNumbers>> verification_programme(fog::Temperature min,
                                                                       fog::Temperature max,
                                                                       double block_s);

}  // namespace fogcomp::board
