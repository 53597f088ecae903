#include "simulation/coil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// Half of the fibre in each layer, from the inside; repeated over the coil. Exchanging A and B only
// changes the sign.
std::string_view half_sequence(WindingPattern pattern) {
  switch (pattern) {
    case WindingPattern::single:
      break;
    case WindingPattern::dipole:
      return "AB";
    case WindingPattern::quadrupole:
      return "BAAB";
    case WindingPattern::octupole:
      return "ABBABAAB";
  }
  return "";
}

// Lays fibre turn by turn, layer by layer, and distributes its weight over the cells.
class FibreLayer {
 public:
  FibreLayer(const CoilGeometry& coil, CellArray& weights) : coil_(coil), weights_(weights) {}

  // Winds one layer, starting `from_midpoint_m` from the midpoint in the given direction (+1: z
  // grows beyond L/2). Returns the distance at its end.
  double wind(int layer, double from_midpoint_m, double sense, bool from_bottom) {
    const double turn_m = 2 * M_PI * coil_.layer_radius_m(layer);
    for (int turn = 0; turn < coil_.turns_per_layer; ++turn) {
      const double middle_m = from_midpoint_m + turn_m / 2;
      // L - 2z = -2 sense * distance, linear along the turn: the mean is the value in the middle.
      const double weight_m2 = -2 * sense * middle_m * turn_m;
      const int place = from_bottom ? turn : coil_.turns_per_layer - 1 - turn;
      spread(layer, place, weight_m2);
      from_midpoint_m += turn_m;
    }
    return from_midpoint_m;
  }

 private:
  // A turn across two axial cells is divided between them.
  void spread(int layer, int place, double weight_m2) {
    const double cells_per_turn = static_cast<double>(weights_.cols()) / coil_.turns_per_layer;
    const double low = place * cells_per_turn;
    const double high = low + cells_per_turn;
    for (auto cell = static_cast<Eigen::Index>(low); cell < weights_.cols(); ++cell) {
      const auto bottom = static_cast<double>(cell);
      const double overlap = std::min(high, bottom + 1) - std::max(low, bottom);
      if (overlap <= 0) break;
      weights_(layer, cell) += weight_m2 * overlap / cells_per_turn;
    }
  }

  const CoilGeometry& coil_;
  CellArray& weights_;
};

}  // namespace

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

CellArray winding_weights(const CoilGeometry& coil, int axial_cells) {
  CellArray weights = CellArray::Zero(coil.layers, axial_cells);
  FibreLayer fibre(coil, weights);
  if (coil.pattern == WindingPattern::single) {
    // From z = L inside to z = 0 outside.
    double distance_m = -coil.fibre_length_m() / 2;
    for (int layer = 0; layer < coil.layers; ++layer) {
      distance_m = fibre.wind(layer, distance_m, -1, layer % 2 == 0);
    }
    return weights;
  }
  const std::string_view halves = half_sequence(coil.pattern);
  const auto half_of = [&](int layer) {
    return halves[static_cast<std::size_t>(layer) % halves.size()] == 'A' ? 0U : 1U;
  };
  std::array<double, 2> length_m{};
  for (int layer = 0; layer < coil.layers; ++layer) {
    length_m[half_of(layer)] += coil.turns_per_layer * 2 * M_PI * coil.layer_radius_m(layer);
  }
  // If the halves differ in length (dipole), winding starts beside the fibre's true midpoint.
  const double offset_m = (length_m[1] - length_m[0]) / 2;
  std::array<double, 2> distance_m{offset_m, -offset_m};
  std::array<bool, 2> from_bottom{true, true};
  for (int layer = 0; layer < coil.layers; ++layer) {
    const std::size_t half = half_of(layer);
    const double sense = half == 0 ? 1 : -1;
    distance_m[half] = fibre.wind(layer, distance_m[half], sense, from_bottom[half]);
    from_bottom[half] = !from_bottom[half];
  }
  return weights;
}

CoilError::CoilError(const CoilGeometry& coil, const FibreMaterial& material, int axial_cells)
    : coil_(coil),
      material_(material),
      kernel_dph_s_(winding_weights(coil, axial_cells) * kDphPerRadps * material.refractive_index /
                    (coil.fibre_length_m() * coil.mean_diameter_m())) {}

double CoilError::lead_dph_s_per_k(double length_m) const {
  return kDphPerRadps * 2 * material_.refractive_index * material_.thermal_phase_per_k() *
         length_m / coil_.mean_diameter_m();
}

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
