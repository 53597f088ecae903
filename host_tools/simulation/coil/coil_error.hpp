#pragma once

#include "simulation/coil/winding.hpp"

namespace fogcomp::simulation {

/// deg/h per rad/s.
constexpr double kDphPerRadps = 206264.80624709636;

/// Rate error due to temperature changes of the coil:
///   W_e = n/(L D) * integral of kappa * dT/dt * (L - 2z) dz,   D the mean diameter
/// (Shupe, Appl. Opt. 19, 654, 1980; kappa includes all causes of a phase change).
class CoilError {
 public:
  CoilError(const CoilGeometry& coil, const FibreMaterial& material, int axial_cells);

  /// `phase_rate_per_s`: kappa dT/dt of every cell, 1/s. Returns deg/h.
  double rate_dph(const CellArray& phase_rate_per_s) const {
    return (kernel_dph_s_ * phase_rate_per_s).sum();
  }

  /// Contribution of a unit of kappa dT/dt in each cell, deg/h per 1/s.
  const CellArray& kernel_dph_s() const { return kernel_dph_s_; }

  /// Error of a fibre whose midpoint is off by `length_m`, the spare lead lying on the outer layer:
  /// deg/h per (K/s) of d/dt(T_outside - T_mean). 2 n kappa d / D.
  double lead_dph_s_per_k(double length_m) const;

  const CoilGeometry& coil() const { return coil_; }
  const FibreMaterial& material() const { return material_; }

 private:
  CoilGeometry coil_;
  FibreMaterial material_;
  CellArray kernel_dph_s_;
};

}  // namespace fogcomp::simulation
