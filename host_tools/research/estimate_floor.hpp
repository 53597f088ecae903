#pragma once

#include "research/simulated_run.hpp"

namespace fogcomp::research {

/// Error due to noise alone: expected rms error, deg/h, on the rows of `asked` of a fit to `fitted`
/// that knows the exact time course of every simulated effect and estimates only the sizes, with
/// weights by the true noise (Cramer-Rao bound of the sizes). A method that has to estimate more
/// has a larger error. Both runs are of one gyro.
double estimate_floor_dph(const SimulatedRun& fitted, const SimulatedRun& asked);

}  // namespace fogcomp::research
