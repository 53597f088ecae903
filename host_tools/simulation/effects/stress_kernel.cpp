#include "simulation/effects/stress_kernel.hpp"

#include "support/units.hpp"

namespace fogcomp::simulation {
CellArray stress_kernel(const CoilError& coil_error, double inside, double outside) {
  const int layers = coil_error.coil().layers;
  CellArray kernel = coil_error.kernel_dph_s() * coil_error.material().strain_phase();
  for (int layer = 0; layer < layers; ++layer) {
    kernel.row(layer) *= inside + (outside - inside) * layer / (layers - 1);
  }
  return kernel;
}

CellArray unit_stress_kernel(const CoilError& coil_error) {
  const CellArray kernel = stress_kernel(coil_error, kStrainInside, kStrainOutside);
  return kernel * (kSecondsPerMinute / kernel.sum());
}

}  // namespace fogcomp::simulation
