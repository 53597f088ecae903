#pragma once

#include <vector>

#include "core/thermal/signals.hpp"
#include "series/block_series.hpp"

namespace fogcomp::series {

/// What the coil saw during each block, without the board's delay: temperature as measured, its
/// rate from a filter that looks both ways.
struct ZeroPhaseSignals {
  std::vector<fog::Signals<model::RealNumbers>> signals;  ///< one per block of the series
  std::vector<bool> restart;                              ///< the first block, and after long gaps
};

/// The board's derivative is late by two time constants and a block, which is nothing against a
/// ramp but shows where a ramp begins or ends: a model judged with it seems to lack an effect. Here
/// the two lags run once forward and once backward over each stretch: the same magnitude at every
/// frequency, no delay. Stretches are continued beyond their ends by reflection in the end point,
/// so that a ramp goes on as a ramp; gaps that the board would hold over are bridged by a line.
ZeroPhaseSignals zero_phase_signals(const BlockSeries& series, double derivative_tau_s);

/// The recording as it would be with a sensor of less noise: temperatures through such lags,
/// forward and backward.
BlockSeries with_smooth_temperature(BlockSeries series, double tau_s);

}  // namespace fogcomp::series
