#include "simulation/effects/stress_kernel.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kSecondsPerMinute = 60;
constexpr double kOutsideShare = 1.0 / 3.0;

}  // namespace

CellArray strain_per_k(const CoilGeometry& coil, int axial_cells, double inside, double outside) {
  CellArray strain(coil.layers, axial_cells);
  for (int layer = 0; layer < coil.layers; ++layer) {
    const double depth = coil.layers > 1 ? static_cast<double>(layer) / (coil.layers - 1) : 0;
    strain.row(layer) = inside + depth * (outside - inside);
  }
  return strain;
}

double stress_coefficient(const CoilError& coil_error, double inside, double outside) {
  const auto axial_cells = static_cast<int>(coil_error.kernel_dph_s().cols());
  const CellArray strain = strain_per_k(coil_error.coil(), axial_cells, inside, outside);
  return coil_error.rate_dph(coil_error.material().strain_phase() * strain) / kSecondsPerMinute;
}

CellArray unit_stress_kernel(const CoilError& coil_error) {
  const auto axial_cells = static_cast<int>(coil_error.kernel_dph_s().cols());
  const CellArray strain = strain_per_k(coil_error.coil(), axial_cells, 1.0, kOutsideShare);
  const CellArray kernel = coil_error.kernel_dph_s() * strain;
  return kernel * (kSecondsPerMinute / kernel.sum());
}

}  // namespace fogcomp::simulation
