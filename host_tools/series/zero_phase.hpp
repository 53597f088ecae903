#pragma once

#include <vector>

#include "series/block_series.hpp"

namespace fogcomp::series {

/// Temperature rate of each block without the board's delay, from a zero-phase filter.
struct ZeroPhaseSignals {
  std::vector<double> temperature_rate;  ///< degC/min, one per block of the series
  std::vector<bool> restart;             ///< the first block, and after long gaps
};

/// The board's derivative has a delay of two time constants and a block. That is negligible against
/// a ramp, but visible where a ramp begins or ends: a model judged with it seems to lack an effect.
/// Here the two lags run once forward and once backward over each stretch: the same magnitude at
/// every frequency, no delay. Stretches are extended by reflection in the end point, so that a ramp
/// continues as a ramp; gaps over which the board holds its drift are interpolated.
ZeroPhaseSignals zero_phase_signals(const BlockSeries& series, double derivative_tau_s);

}  // namespace fogcomp::series
