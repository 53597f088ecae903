#pragma once

#include "simulation/coil/coil_error.hpp"

namespace fogcomp::simulation {

/// The part of the coil integral due to thermal stress, deg/h per K/s in each cell, for an
/// orthoradial strain of the fibre per K that varies linearly from `inside` at the spool to
/// `outside`, both per K.
CellArray stress_kernel(const CoilError& coil_error, double inside, double outside);

/// Default strains, per K: the order of published values, 4 and 12 ppm/K at the two sides.
constexpr double kStrainInside = 4e-6;
constexpr double kStrainOutside = 12e-6;

/// The same with the default strains, scaled so that a uniform 1 K/min gives 1 deg/h.
CellArray unit_stress_kernel(const CoilError& coil_error);

}  // namespace fogcomp::simulation
