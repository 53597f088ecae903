#pragma once

#include "model/model.hpp"

namespace fogcomp::board {

/// Seconds after a start until nothing of the model's lags remembers that they were started: seven
/// time constants of the derivative, whose two lags in a row are then within 1 %, and five of the
/// slowest lag behind it, of an effect, an expression or a network's input, which is too. A play
/// operator forgets with the temperature, not with time: the board says history_unknown.
double settling_time_s(const model::Model& model);

}  // namespace fogcomp::board
