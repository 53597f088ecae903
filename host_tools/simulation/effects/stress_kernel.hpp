#pragma once

#include "simulation/coil/coil_error.hpp"

namespace fogcomp::simulation {

/// Orthoradial strain of the fibre per K, by layer: `inside` at the spool falling in a straight
/// line to `outside`, both per K. Layers by axial cells.
CellArray strain_per_k(const CoilGeometry& coil, int axial_cells, double inside, double outside);

/// The part of the coil integral that thermal stress causes, for a strain that falls to a third
/// from the spool to the outside (12 to 4 ppm/K is assumed in effects.md, section 1), scaled to
/// one: its sum over a uniform 1 K/min is 1 deg/h. Multiply by dT/dt in K/s.
CellArray unit_stress_kernel(const CoilError& coil_error);

/// deg/h per K/min of a uniform temperature rate for a given strain: the size that the physics
/// predicts where the strains are known.
double stress_coefficient(const CoilError& coil_error, double inside, double outside);

}  // namespace fogcomp::simulation
