#include "simulation/coil/coil_geometry.hpp"

#include <cmath>

namespace fogcomp::simulation {

double CoilGeometry::fibre_length_m() const {
  double length_m = 0;
  for (int layer = 0; layer < layers; ++layer) {
    length_m += turns_per_layer * 2 * M_PI * layer_radius_m(layer);
  }
  return length_m;
}

double FibreMaterial::strain_phase() const {
  const double n = refractive_index;
  return n * (1 - n * n / 2 *
                      (strain_optic_p12 - poisson_ratio * (strain_optic_p11 + strain_optic_p12)));
}

double glass_share(const CoilGeometry& coil, const FibreMaterial& material) {
  const double turn_area_m2 = coil.layer_thickness_m() * coil.height_m / coil.turns_per_layer;
  return M_PI / 4 * material.glass_diameter_m * material.glass_diameter_m / turn_area_m2;
}

PackProperties pack_properties(const CoilGeometry& coil, const FibreMaterial& material) {
  const double glass = glass_share(coil, material);
  const double k_glass = material.glass_conductivity_w_per_mk;
  const double k_matrix = material.coating_conductivity_w_per_mk;
  const double numerator = (1 + glass) * k_glass + (1 - glass) * k_matrix;
  const double denominator = (1 - glass) * k_glass + (1 + glass) * k_matrix;
  return {k_matrix * numerator / denominator,
          glass * material.glass_heat_j_per_m3k + (1 - glass) * material.coating_heat_j_per_m3k};
}

}  // namespace fogcomp::simulation
