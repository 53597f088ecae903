#pragma once

#include <vector>

#include "series/block_series.hpp"

namespace fogcomp::series {

/// What the coil saw during each block beside the temperature as measured: its rate without the
/// board's delay, from a filter that looks both ways.
struct ZeroPhaseSignals {
  std::vector<double> temperature_rate;  ///< degC/min, one per block of the series
  std::vector<bool> restart;             ///< the first block, and after long gaps
};

/// The board's derivative is late by two time constants and a block, which is nothing against a
/// ramp but shows where a ramp begins or ends: a model judged with it seems to lack an effect. Here
/// the two lags run once forward and once backward over each stretch: the same magnitude at every
/// frequency, no delay. Stretches are continued beyond their ends by reflection in the end point,
/// so that a ramp goes on as a ramp; gaps that the board would hold over are bridged by a line.
ZeroPhaseSignals zero_phase_signals(const BlockSeries& series, double derivative_tau_s);

/// Per block, degC: what a sensor of less noise would have seen, the temperature through such lags,
/// forward and backward.
std::vector<double> smooth_temperatures(const BlockSeries& series, double tau_s);

}  // namespace fogcomp::series
