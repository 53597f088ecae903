#pragma once

#include "research/simulated_run.hpp"

namespace fogcomp::research {

/// What is left for noise alone to spoil: the rms error, deg/h, that is to be expected on the rows
/// of `asked` of a fit to `fitted` which knew the exact course of every effect of the simulator and
/// had but their sizes to find, its rows weighted with the noise that they really have (Cramer-Rao
/// bound of those sizes). Whoever must find out more from `fitted` than that errs more. Both runs
/// are of one gyro.
double estimate_floor_dph(const SimulatedRun& fitted, const SimulatedRun& asked);

}  // namespace fogcomp::research
