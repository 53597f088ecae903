#include "simulation/thermal/gyro_thermal_model.hpp"

#include <cmath>

namespace fogcomp::simulation {
namespace {

// A titanium alloy (Ti-6Al-4V), common for spools because it expands little.
constexpr double kSpoolHeat_j_per_m3k = 4430.0 * 560.0;
constexpr double kSpoolConductivity_w_per_mk = 7.0;

double ring_area_m2(double inner_m, double outer_m) {
  return M_PI * (outer_m * outer_m - inner_m * inner_m);
}

}  // namespace

GyroThermalModel::GyroThermalModel(const CoilGeometry& coil, const FibreMaterial& material,
                                   const GyroThermalDesign& design, const ThermalGrid& grid,
                                   double start_degc)
    : axial_cells_(grid.axial_cells),
      cells_per_layer_(grid.cells_per_layer),
      self_heating_w_(design.self_heating_w),
      integrator_(build_network(coil, material, design, grid), grid.step_s, start_degc),
      volume_share_(coil.layers, grid.axial_cells),
      coil_degc_(coil.layers, grid.axial_cells),
      coil_rate_kps_(coil.layers, grid.axial_cells),
      power_w_(Eigen::VectorXd::Zero(integrator_.temperature_degc().size())) {
  for (int layer = 0; layer < coil.layers; ++layer) {
    volume_share_.row(layer) = coil.layer_radius_m(layer);
  }
  volume_share_ /= volume_share_.sum();
  read_coil();
}

ThermalNetwork GyroThermalModel::build_network(const CoilGeometry& coil,
                                               const FibreMaterial& material,
                                               const GyroThermalDesign& design,
                                               const ThermalGrid& grid) {
  ThermalNetwork network;
  const PackProperties pack = pack_properties(coil, material);
  add_coil(network, coil, pack, grid);
  add_spool(network, coil, pack, design, grid);
  add_hub(network, design, grid);
  add_surroundings(network, coil, pack, design, grid);
  return network;
}

// Nodes 0 .. radial cells * axial cells - 1, as cell() numbers them.
void GyroThermalModel::add_coil(ThermalNetwork& network, const CoilGeometry& coil,
                                const PackProperties& pack, const ThermalGrid& grid) {
  const int radial_cells = coil.layers * grid.cells_per_layer;
  const double thickness_m = coil.layer_thickness_m() / grid.cells_per_layer;
  const double height_m = coil.height_m / grid.axial_cells;
  for (int i = 0; i < radial_cells; ++i) {
    const double inner_m = coil.inner_radius_m + i * thickness_m;
    const double area_m2 = ring_area_m2(inner_m, inner_m + thickness_m);
    for (int j = 0; j < grid.axial_cells; ++j) {
      network.add_node(pack.heat_j_per_m3k * area_m2 * height_m);
      if (j > 0) {
        network.connect(cell(i, j - 1), cell(i, j),
                        pack.conductivity_w_per_mk * area_m2 / height_m);
      }
      if (i > 0) {
        // Between the mean radii of two cylindrical shells.
        const double logarithm =
            std::log((inner_m + 0.5 * thickness_m) / (inner_m - 0.5 * thickness_m));
        network.connect(cell(i - 1, j), cell(i, j),
                        pack.conductivity_w_per_mk * 2 * M_PI * height_m / logarithm);
      }
    }
  }
}

// Spool wall along the inner layer, with a flange at either end.
void GyroThermalModel::add_spool(ThermalNetwork& network, const CoilGeometry& coil,
                                 const PackProperties& pack, const GyroThermalDesign& design,
                                 const ThermalGrid& grid) {
  const int radial_cells = coil.layers * grid.cells_per_layer;
  const double thickness_m = coil.layer_thickness_m() / grid.cells_per_layer;
  const double height_m = coil.height_m / grid.axial_cells;
  const double wall_area_m2 =
      ring_area_m2(coil.inner_radius_m - design.spool_wall_m, coil.inner_radius_m);
  const double flange_area_m2 = ring_area_m2(coil.inner_radius_m, coil.outer_radius_m);
  for (int j = 0; j < grid.axial_cells; ++j) {
    const bool at_flange = j == 0 || j == grid.axial_cells - 1;
    const double volume_m3 =
        wall_area_m2 * height_m + (at_flange ? flange_area_m2 * design.spool_wall_m : 0);
    const auto spool = network.add_node(kSpoolHeat_j_per_m3k * volume_m3);
    if (j == 0) {
      spool_first_ = spool;
    } else {
      network.connect(spool - 1, spool, kSpoolConductivity_w_per_mk * wall_area_m2 / height_m);
    }
    spool_last_ = spool;
    const double to_cell_middle = std::log(1 + 0.5 * thickness_m / coil.inner_radius_m);
    network.connect(spool, cell(0, j),
                    pack.conductivity_w_per_mk * 2 * M_PI * height_m / to_cell_middle);
  }
  for (int i = 0; i < radial_cells; ++i) {
    const double inner_m = coil.inner_radius_m + i * thickness_m;
    const double area_m2 = ring_area_m2(inner_m, inner_m + thickness_m);
    // Glue joint and half a cell in series.
    const double face_w_per_k =
        area_m2 / (1 / design.flange_w_per_m2k + 0.5 * height_m / pack.conductivity_w_per_mk);
    network.connect(spool_first_, cell(i, 0), face_w_per_k);
    network.connect(spool_last_, cell(i, grid.axial_cells - 1), face_w_per_k);
  }
}

// Inside the spool: two lumps in a chain, so that the lag is not first-order.
void GyroThermalModel::add_hub(ThermalNetwork& network, const GyroThermalDesign& design,
                               const ThermalGrid& grid) {
  const auto hub_rim = network.add_node(0.4 * design.hub_j_per_k);
  hub_core_ = network.add_node(0.6 * design.hub_j_per_k);
  // The slower of the chain's two modes has the stated time constant: with equal conductances g and
  // capacities 0.4 C and 0.6 C it is 1.43 C / g.
  const double hub_w_per_k = 1.43 * design.hub_j_per_k / design.hub_time_constant_s;
  network.connect(spool_first_ + grid.axial_cells / 2, hub_rim, hub_w_per_k);
  network.connect(hub_rim, hub_core_, hub_w_per_k);
}

void GyroThermalModel::add_surroundings(ThermalNetwork& network, const CoilGeometry& coil,
                                        const PackProperties& pack, const GyroThermalDesign& design,
                                        const ThermalGrid& grid) {
  const int outermost = coil.layers * grid.cells_per_layer - 1;
  cover_ = network.add_node(0.5 * design.housing_j_per_k);
  base_ = network.add_node(0.5 * design.housing_j_per_k);
  network.connect(cover_, base_, design.cover_to_base_w_per_k);
  network.connect_to_air(cover_, 0.6 * design.housing_to_air_w_per_k);
  network.connect_to_air(base_, 0.4 * design.housing_to_air_w_per_k);
  network.connect(spool_first_, base_, design.spool_to_base_w_per_k);
  const double side_m2 = 2 * M_PI * coil.outer_radius_m * coil.height_m / grid.axial_cells;
  // Air gap and half a cell in series.
  const double half_cell_m = 0.5 * coil.layer_thickness_m() / grid.cells_per_layer;
  const double side_w_per_k =
      side_m2 / (1 / design.coil_to_cover_w_per_m2k + half_cell_m / pack.conductivity_w_per_mk);
  for (int j = 0; j < grid.axial_cells; ++j) {
    network.connect(cell(outermost, j), cover_, side_w_per_k);
  }
  const double top_m2 = ring_area_m2(coil.inner_radius_m, coil.outer_radius_m);
  network.connect(spool_last_, cover_, design.upper_flange_to_cover_w_per_m2k * top_m2);
  optics_ = network.add_node(design.optics_j_per_k);
  network.connect(optics_, base_, design.optics_to_base_w_per_k);
  if (design.slab_j_per_k > 0) {
    const auto slab = network.add_node(design.slab_j_per_k);
    network.connect_to_air(slab, design.slab_j_per_k / design.slab_time_constant_s);
    network.connect(slab, base_, design.slab_to_base_w_per_k);
  }
}

void GyroThermalModel::step(double air_degc, double spool_heater_w, bool powered) {
  // A film heater around the spool's wall, denser towards the lower flange.
  const double shares = axial_cells_ * (axial_cells_ + 1) / 2.0;
  for (int j = 0; j < axial_cells_; ++j) {
    power_w_[spool_first_ + j] = spool_heater_w * (axial_cells_ - j) / shares;
  }
  power_w_[optics_] = powered ? self_heating_w_ : 0;
  integrator_.step(air_degc, power_w_);
  read_coil();
}

void GyroThermalModel::read_coil() {
  for (Eigen::Index layer = 0; layer < coil_degc_.rows(); ++layer) {
    for (Eigen::Index axial = 0; axial < axial_cells_; ++axial) {
      double degc = 0;
      double kps = 0;
      for (int part = 0; part < cells_per_layer_; ++part) {
        const auto node = (layer * cells_per_layer_ + part) * axial_cells_ + axial;
        degc += integrator_.temperature_degc()[node];
        kps += integrator_.rate_kps()[node];
      }
      coil_degc_(layer, axial) = degc / cells_per_layer_;
      coil_rate_kps_(layer, axial) = kps / cells_per_layer_;
    }
  }
}

}  // namespace fogcomp::simulation
