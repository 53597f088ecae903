// The coil integral against the closed forms of the literature.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/coil.hpp"

namespace fogcomp::simulation {
namespace {

constexpr int kAxialCells = 5;
constexpr double kPerMinute = 1.0 / 60;

// All turns equally long, as the closed forms assume: a pack that is very thin for its diameter.
CoilGeometry thin_coil(WindingPattern pattern) {
  CoilGeometry coil;
  coil.inner_radius_m = 0.05775;
  coil.outer_radius_m = 0.05775 + 5.5e-6;
  coil.pattern = pattern;
  return coil;
}

// deg/h of a temperature rate that rises in a straight line from layer to layer by 1 K/min over the
// pack.
double linear_profile_dph(const CoilError& error) {
  const CoilGeometry& coil = error.coil();
  CellArray rate_kps(coil.layers, kAxialCells);
  for (int layer = 0; layer < coil.layers; ++layer) {
    rate_kps.row(layer) = kPerMinute * (layer + 0.5) / coil.layers;
  }
  return error.rate_dph(error.material().thermal_phase_per_k() * rate_kps);
}

double n_kappa_l_over_d_dph(const CoilGeometry& coil) {
  const FibreMaterial glass;
  return kDphPerRadps * glass.refractive_index * glass.thermal_phase_per_k() *
         coil.fibre_length_m() / coil.mean_diameter_m() * kPerMinute;
}

TEST(CoilError, IsZeroForAUniformTemperatureRateWhateverTheWinding) {
  for (const auto pattern : {WindingPattern::single, WindingPattern::dipole,
                             WindingPattern::quadrupole, WindingPattern::octupole}) {
    for (const int layers : {40, 37}) {
      CoilGeometry coil;
      coil.layers = layers;
      coil.pattern = pattern;
      const CellArray weights = winding_weights(coil, kAxialCells);
      EXPECT_LT(std::abs(weights.sum()), 1e-12 * weights.abs().sum()) << layers << " layers";
    }
  }
}

TEST(CoilError, HasTheWholeWeightOfTheFibre) {
  // Integral of |L - 2z| is L^2 / 2, whatever the winding.
  for (const auto pattern : {WindingPattern::single, WindingPattern::quadrupole}) {
    CoilGeometry coil;
    coil.pattern = pattern;
    const double length_m = coil.fibre_length_m();
    EXPECT_NEAR(winding_weights(coil, kAxialCells).abs().sum(), length_m * length_m / 2,
                2e-3 * length_m * length_m);
  }
}

TEST(CoilError, MatchesTheClosedFormOfASingleWinding) {
  const CoilGeometry coil = thin_coil(WindingPattern::single);
  const double expected = n_kappa_l_over_d_dph(coil) / 6;
  EXPECT_NEAR(linear_profile_dph(CoilError(coil, {}, kAxialCells)), expected, 0.03 * expected);
}

TEST(CoilError, MatchesTheClosedFormOfADipoleWinding) {
  const CoilGeometry coil = thin_coil(WindingPattern::dipole);
  const double expected = n_kappa_l_over_d_dph(coil) / (4 * coil.layers);
  EXPECT_NEAR(linear_profile_dph(CoilError(coil, {}, kAxialCells)), expected, 0.03 * expected);
}

TEST(CoilError, MatchesTheClosedFormOfAQuadrupoleWinding) {
  const CoilGeometry coil = thin_coil(WindingPattern::quadrupole);
  const double expected = n_kappa_l_over_d_dph(coil) / (2 * coil.layers * coil.layers);
  EXPECT_NEAR(linear_profile_dph(CoilError(coil, {}, kAxialCells)), expected, 0.03 * expected);
}

TEST(CoilError, OfARealQuadrupoleIsWhatTheReferenceCoilHas) {
  // 0.160 deg/h per (K/min) with real radii, 0.003 for an octupole.
  CoilGeometry coil;
  EXPECT_NEAR(linear_profile_dph(CoilError(coil, {}, kAxialCells)), 0.160, 0.03 * 0.160);
  coil.pattern = WindingPattern::octupole;
  EXPECT_LT(std::abs(linear_profile_dph(CoilError(coil, {}, kAxialCells))), 0.02);
}

TEST(CoilError, OfAQuadrupoleIgnoresAnAxialGradientToFirstOrder) {
  const CoilError error(CoilGeometry{}, {}, kAxialCells);
  CellArray rate_kps(40, kAxialCells);
  for (int j = 0; j < kAxialCells; ++j) rate_kps.col(j) = kPerMinute * j / (kAxialCells - 1);
  const double axial = error.rate_dph(error.material().thermal_phase_per_k() * rate_kps);
  EXPECT_LT(std::abs(axial), 0.05 * linear_profile_dph(error));
}

TEST(CoilError, OfAnUncentredFibreIsThatOfTheEffectiveLength) {
  // 2 n kappa d / D: 0.92 deg/h per (K/min) and metre.
  const CoilError error(CoilGeometry{}, {}, kAxialCells);
  EXPECT_NEAR(error.lead_dph_s_per_k(1) * kPerMinute, 0.92, 0.01);
}

TEST(StressKernel, GivesThePredictedSizeForTheAssumedStrains) {
  // 0.136 deg/h per (K/min) for 12 ppm/K at one side and 4 ppm/K at the other.
  const CoilError error(CoilGeometry{}, {}, kAxialCells);
  EXPECT_NEAR(stress_kernel(error, 4e-6, 12e-6).sum() * kPerMinute, 0.136, 0.005);
  // A stress that is the same in all layers does nothing.
  EXPECT_NEAR(stress_kernel(error, 8e-6, 8e-6).sum(), 0, 1e-10);
}

TEST(StressKernel, IsScaledToOneDegreePerHourAtOneKelvinPerMinute) {
  const CoilError error(CoilGeometry{}, {}, kAxialCells);
  EXPECT_NEAR(unit_stress_kernel(error).sum() * kPerMinute, 1, 1e-12);
}

}  // namespace
}  // namespace fogcomp::simulation
