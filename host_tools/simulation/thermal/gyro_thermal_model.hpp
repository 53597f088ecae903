#pragma once

#include "simulation/coil.hpp"
#include "simulation/thermal/thermal_network.hpp"

namespace fogcomp::simulation {

/// The gyro around its coil, as lumped masses. The default housing follows the chamber's air with
/// 15 to 20 min, coil and spool follow the housing with about 5 min.
struct GyroThermalDesign {
  double housing_j_per_k = 600;
  double housing_to_air_w_per_k = 0.65;
  double cover_to_base_w_per_k = 3;
  double optics_j_per_k = 60;  ///< integrated optics, coupler, source and their board
  double optics_to_base_w_per_k = 0.35;
  double self_heating_w = 1.0;  ///< electronics, on the optics board
  double spool_wall_m = 0.003;
  double spool_to_base_w_per_k = 0.25;
  double coil_to_cover_w_per_m2k = 10;  ///< still air and radiation
  double upper_flange_to_cover_w_per_m2k = 10;
  double flange_w_per_m2k = 150;  ///< coil faces against the spool's flanges, glued
  double hub_j_per_k = 25;        ///< mass inside the spool, on an elastic bond
  double hub_time_constant_s = 400;
  double slab_j_per_k = 0;  ///< stone under the gyro; 0: none
  double slab_time_constant_s = 5400;
  double slab_to_base_w_per_k = 0.1;
};

/// Resolution of the pack and of time.
struct ThermalGrid {
  int cells_per_layer = 1;
  int axial_cells = 5;  ///< odd, so that one is at mid-height
  double step_s = 1;    ///< of heat flow, effects and sensors; rows are interpolated or averaged
};

/// Heat flow through coil, spool, hub, optics, housing and base: finite volumes over the pack
/// (layers by axial cells, cylindrical), lumps for the rest.
class GyroThermalModel {
 public:
  GyroThermalModel(const CoilGeometry& coil, const FibreMaterial& material,
                   const GyroThermalDesign& design, const ThermalGrid& grid, double start_degc);

  /// `air_degc`: at the end of the step; self-heating only while `powered`.
  void step(double air_degc, double spool_heater_w, bool powered);

  /// Layer means over the cells of a layer; layers by axial cells.
  const CellArray& coil_degc() const { return coil_degc_; }
  const CellArray& coil_rate_kps() const { return coil_rate_kps_; }
  double coil_mean_degc() const { return (coil_degc_ * volume_share_).sum(); }
  double coil_mean_rate_kps() const { return (coil_rate_kps_ * volume_share_).sum(); }
  /// Outermost layer at mid-height, where a coil sensor is glued.
  double coil_outside_degc() const { return coil_degc_(coil_degc_.rows() - 1, middle()); }
  double coil_outside_rate_kps() const { return coil_rate_kps_(coil_degc_.rows() - 1, middle()); }

  /// Lower face of the pack less upper face.
  double axial_difference_k() const {
    return coil_degc_.col(0).mean() - coil_degc_.col(axial_cells_ - 1).mean();
  }
  double axial_difference_rate_kps() const {
    return coil_rate_kps_.col(0).mean() - coil_rate_kps_.col(axial_cells_ - 1).mean();
  }

  double lower_flange_degc() const { return temperature(spool_first_); }
  double hub_rate_kps() const { return rate(hub_core_); }
  double optics_degc() const { return temperature(optics_); }
  double cover_degc() const { return temperature(cover_); }

 private:
  ThermalNetwork build_network(const CoilGeometry& coil, const FibreMaterial& material,
                               const GyroThermalDesign& design, const ThermalGrid& grid);
  void add_coil(ThermalNetwork& network, const CoilGeometry& coil, const PackProperties& pack,
                const ThermalGrid& grid);
  void add_spool(ThermalNetwork& network, const CoilGeometry& coil, const PackProperties& pack,
                 const GyroThermalDesign& design, const ThermalGrid& grid);
  void add_hub(ThermalNetwork& network, const GyroThermalDesign& design, const ThermalGrid& grid);
  void add_surroundings(ThermalNetwork& network, const CoilGeometry& coil,
                        const PackProperties& pack, const GyroThermalDesign& design,
                        const ThermalGrid& grid);
  void read_coil();
  ThermalNetwork::Node cell(int radial, int axial) const { return radial * axial_cells_ + axial; }
  Eigen::Index middle() const { return axial_cells_ / 2; }
  double temperature(ThermalNetwork::Node node) const {
    return integrator_.temperature_degc()[node];
  }
  double rate(ThermalNetwork::Node node) const { return integrator_.rate_kps()[node]; }

  int axial_cells_;
  int cells_per_layer_;
  double self_heating_w_;
  ThermalNetwork::Node spool_first_ = 0;
  ThermalNetwork::Node spool_last_ = 0;
  ThermalNetwork::Node hub_core_ = 0;
  ThermalNetwork::Node optics_ = 0;
  ThermalNetwork::Node cover_ = 0;
  ThermalNetwork::Node base_ = 0;
  ThermalIntegrator
      integrator_;  // after the node numbers, which the construction of its network sets
  CellArray volume_share_;
  CellArray coil_degc_;
  CellArray coil_rate_kps_;
  Eigen::VectorXd power_w_;
};

}  // namespace fogcomp::simulation
