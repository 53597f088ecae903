#pragma once

#include <string>

#include "model/model.hpp"

namespace fogcomp::board {

/// Seconds after a start until the initial states of the model's lags are negligible (1 %): seven
/// time constants of the derivative, which has two lags, plus five of the slowest lag after it, of
/// an effect, an expression or a network input. A play operator depends on the temperature, not on
/// time: the board reports it by history_unknown.
double settling_time_s(const model::Model& model);

/// "no rate is valid for the first 3228 s after power-on, until the lags of thermal_lag have
/// settled"; "" if no lag but the derivative's takes its time.
std::string settling_words(const model::Model& model);

}  // namespace fogcomp::board
