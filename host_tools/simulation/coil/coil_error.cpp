#include "simulation/coil/coil_error.hpp"

namespace fogcomp::simulation {

CoilError::CoilError(const CoilGeometry& coil, const FibreMaterial& material, int axial_cells)
    : coil_(coil),
      material_(material),
      kernel_dph_s_(winding_weights(coil, axial_cells) * kDphPerRadps * material.refractive_index /
                    (coil.fibre_length_m() * coil.mean_diameter_m())) {}

double CoilError::lead_dph_s_per_k(double length_m) const {
  return kDphPerRadps * 2 * material_.refractive_index * material_.thermal_phase_per_k() *
         length_m / coil_.mean_diameter_m();
}

}  // namespace fogcomp::simulation
