#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace fogcomp::simulation {

/// Distribution of the two halves of the fibre, counted from its midpoint, over the layers.
enum class WindingPattern : std::uint8_t {
  single,      ///< wound from end to end: the midpoint is in the middle layer
  dipole,      ///< AB AB: the halves alternate
  quadrupole,  ///< ABBA ABBA
  octupole,    ///< ABBABAAB
};

/// The wound pack. The default is the only coil with complete published data (Li et al., Chin. Opt.
/// Lett. 13(9) 090603, 2015): 998 m of fibre, 40 layers of 68 turns, quadrupolar.
struct CoilGeometry {
  double inner_radius_m = 0.055;
  double outer_radius_m = 0.0605;
  double height_m = 0.013;
  int layers = 40;
  int turns_per_layer = 68;
  WindingPattern pattern = WindingPattern::quadrupole;

  double mean_diameter_m() const { return inner_radius_m + outer_radius_m; }
  double layer_thickness_m() const { return (outer_radius_m - inner_radius_m) / layers; }
  /// Radius of the fibre in `layer`, counted from the inside.
  double layer_radius_m(int layer) const {
    return inner_radius_m + (layer + 0.5) * layer_thickness_m();
  }
  double fibre_length_m() const;
};

/// Glass and surrounding materials of the pack; values from the same source unless noted.
struct FibreMaterial {
  double refractive_index = 1.44;
  double thermo_optic_per_k = 1.0e-5;  ///< dn/dT at 20 degC
  /// Relative change of dn/dT per K: silica at 1.55 um, from about 8.5e-6 /K at 20 degC (G. Rego,
  /// Sensors 23, 6023, 2023).
  double thermo_optic_slope_per_k = 2.0e-3;
  double expansion_per_k = 5.5e-7;
  double strain_optic_p11 = 0.121;
  double strain_optic_p12 = 0.270;
  double poisson_ratio = 0.17;  ///< fused silica
  double glass_diameter_m = 125e-6;
  double glass_conductivity_w_per_mk = 1.38;
  double coating_conductivity_w_per_mk = 0.21;  ///< coating and glue alike
  double glass_heat_j_per_m3k = 2203.0 * 703.0;
  double coating_heat_j_per_m3k = 1190.0 * 1400.0;

  /// dn/dT + n alpha, per K: change of the index and of the length of a free fibre.
  double thermal_phase_per_k() const {
    return thermo_optic_per_k + refractive_index * expansion_per_k;
  }
  /// C_e: optical path change per length and axial strain, n [1 - n^2/2 (p12 - nu (p11 + p12))].
  double strain_phase() const;
};

/// Effective thermal properties across the fibres: glass cylinders in a matrix of coating and glue.
struct PackProperties {
  double conductivity_w_per_mk;
  double heat_j_per_m3k;
};

/// Fraction of the winding's cross-section that is glass, below 1.
double glass_share(const CoilGeometry& coil, const FibreMaterial& material);

/// Volume mean of the heat capacities, Rayleigh's formula for the conductivity across parallel
/// cylinders (Phil. Mag. 34, 481, 1892, first order).
PackProperties pack_properties(const CoilGeometry& coil, const FibreMaterial& material);

/// One value per cell of the pack: row = layer from the inside, column = axial cell from the
/// bottom.
using CellArray = Eigen::ArrayXXd;

/// Weight of the fibre in every cell: integral of (L - 2z) dz over the fibre in it, in m^2, z being
/// the distance along the fibre and L its length. Each turn is placed in its layer and at its
/// height, at its true distance from the midpoint; a half that fills a layer from the bottom fills
/// its next layer from the top.
///
/// The sum over all cells is zero: a uniform temperature rate makes no rate error. With this sign a
/// coil warmed from outside has a positive error.
CellArray winding_weights(const CoilGeometry& coil, int axial_cells);

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
