// Heat flow against closed forms, and its convergence in space and time.
#include <gtest/gtest.h>

#include <cmath>

#include "simulation/coil.hpp"
#include "simulation/thermal/gyro_thermal_model.hpp"

namespace fogcomp::simulation {
namespace {

// A coil whose outer side is at the air's temperature at once and whose inside and faces are
// insulated: only conduction through the pack is left.
GyroThermalDesign bare_coil() {
  GyroThermalDesign design;
  design.housing_j_per_k = 1e-6;
  design.housing_to_air_w_per_k = 1e6;
  design.cover_to_base_w_per_k = 1e6;
  design.coil_to_cover_w_per_m2k = 1e6;
  design.upper_flange_to_cover_w_per_m2k = 0;
  design.spool_wall_m = 1e-9;
  design.spool_to_base_w_per_k = 0;
  design.flange_w_per_m2k = 1e-9;
  design.hub_j_per_k = 1e-6;
  design.self_heating_w = 0;
  return design;
}

double diffusivity_m2_per_s(const PackProperties& pack) {
  return pack.conductivity_w_per_mk / pack.heat_j_per_m3k;
}

// Radius-averaged eigenvalue problem of a cylindrical shell, insulated inside, cold outside:
// J0'(k a) Y0(k b) = Y0'(k a) J0(k b). The slowest root by bisection.
double slowest_time_constant_s(double inner_m, double outer_m, double diffusivity_m2_per_s) {
  const auto mismatch = [&](double k) {
    return std::cyl_bessel_j(1, k * inner_m) * std::cyl_neumann(0, k * outer_m) -
           std::cyl_neumann(1, k * inner_m) * std::cyl_bessel_j(0, k * outer_m);
  };
  const double plane = M_PI / 2 / (outer_m - inner_m);
  double low = 0.8 * plane;
  double high = 1.2 * plane;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    ((mismatch(low) < 0) == (mismatch(middle) < 0) ? low : high) = middle;
  }
  return 1 / (diffusivity_m2_per_s * low * low);
}

TEST(Pack, ConductsAsTheReferenceCoil) {
  // 45 s one-sided for 5.5 mm needs a diffusivity of 2.7e-7 m2/s.
  EXPECT_NEAR(diffusivity_m2_per_s(pack_properties(CoilGeometry{}, {})), 2.7e-7, 0.1e-7);
}

TEST(ThermalModel, HasTheSlowestDiffusionModeOfACylindricalShell) {
  const CoilGeometry coil;
  const double step_s = 0.25;
  GyroThermalModel model(coil, {}, bare_coil(), {1, 5, step_s}, 0);
  const double expected_s = slowest_time_constant_s(
      coil.inner_radius_m, coil.outer_radius_m, diffusivity_m2_per_s(pack_properties(coil, {})));
  EXPECT_NEAR(expected_s, 45, 3);
  for (int i = 0; i < 800; ++i) model.step(1, 0, true);  // 200 s: only the slowest mode is left
  const double before = 1 - model.coil_degc()(0, 0);
  for (int i = 0; i < 200; ++i) model.step(1, 0, true);
  const double after = 1 - model.coil_degc()(0, 0);
  EXPECT_NEAR(50 / std::log(before / after), expected_s, 0.01 * expected_s);
}

// The Shupe error of the real coil, 60 s after the air begins to warm at 1 K/min.
double shupe_dph(const GyroThermalDesign& design, const ThermalGrid& grid) {
  const CoilGeometry coil;
  const FibreMaterial glass;
  GyroThermalModel model(coil, glass, design, grid, 20);
  const CoilError error(coil, glass, grid.axial_cells);
  const auto steps = static_cast<int>(std::lround(60 / grid.step_s));
  for (int i = 1; i <= steps; ++i) model.step(20 + i * grid.step_s / 60, 0, true);
  return error.rate_dph(glass.thermal_phase_per_k() * model.coil_rate_kps());
}

TEST(ThermalModel, ConvergesWithTheGrid) {
  const double coarse = shupe_dph(bare_coil(), {1, 5, 0.5});
  const double fine = shupe_dph(bare_coil(), {2, 5, 0.5});
  const double finest = shupe_dph(bare_coil(), {4, 5, 0.5});
  EXPECT_NEAR(coarse, finest, 0.01 * std::abs(finest));
  // Second order: each halving leaves a quarter of the error.
  EXPECT_LT(std::abs(fine - finest), 0.3 * std::abs(coarse - finest));
  EXPECT_NEAR(shupe_dph({}, {1, 5, 0.5}), shupe_dph({}, {1, 9, 0.5}), 0.02 * std::abs(finest));
}

TEST(ThermalModel, ConvergesWithTheTimeStep) {
  const double exact = shupe_dph(bare_coil(), {1, 5, 0.0625});
  const double at_1s = std::abs(shupe_dph(bare_coil(), {1, 5, 1}) - exact);
  const double at_2s = std::abs(shupe_dph(bare_coil(), {1, 5, 2}) - exact);
  EXPECT_LT(at_1s, 0.01 * std::abs(exact));
  EXPECT_LT(at_1s, 0.35 * at_2s);  // second order: a quarter
}

TEST(ThermalModel, FollowsALongRampAtItsRateEverywhere) {
  GyroThermalModel model(CoilGeometry{}, {}, {}, {}, 20);
  const double rate_kps = 0.5 / 60;
  for (int i = 1; i <= 20000; ++i) model.step(20 + rate_kps * i, 0, true);
  EXPECT_NEAR(model.coil_rate_kps().minCoeff(), rate_kps, 1e-6 * rate_kps);
  EXPECT_NEAR(model.coil_rate_kps().maxCoeff(), rate_kps, 1e-6 * rate_kps);
  // Lag of the coil behind the air: housing, then coil and spool (15 to 30 min).
  const double lag_s = (20 + rate_kps * 20000 - model.coil_mean_degc() + 1.6) / rate_kps;
  EXPECT_GT(lag_s, 900);
  EXPECT_LT(lag_s, 1800);
}

TEST(ThermalModel, EndsWhereTheHeatBalanceSays) {
  GyroThermalDesign design;
  design.self_heating_w = 1;
  GyroThermalModel model(CoilGeometry{}, {}, design, {1, 5, 10}, 20);
  for (int i = 0; i < 5000; ++i) model.step(20, 0, true);
  // The optics' one watt leaves through the housing: somewhat more than 1 W / (W/K) warm.
  EXPECT_NEAR(model.cover_degc(), 20 + 1 / design.housing_to_air_w_per_k, 0.2);
  // 0.6 of the housing's conductance is the cover's; the base dissipates the rest.
  const double by_cover_w = 0.6 * design.housing_to_air_w_per_k * (model.cover_degc() - 20);
  const double base_degc = 20 + (1 - by_cover_w) / (0.4 * design.housing_to_air_w_per_k);
  EXPECT_NEAR(model.optics_degc() - base_degc, 1 / design.optics_to_base_w_per_k, 1e-6);
  for (int i = 0; i < 5000; ++i) model.step(20, 0, false);
  EXPECT_NEAR(model.coil_mean_degc(), 20, 1e-6);
}

TEST(ThermalModel, HubFollowsWithTheTimeConstantAskedFor) {
  GyroThermalDesign design;
  design.hub_time_constant_s = 6000;  // far longer than all others, so that it alone is left
  design.hub_j_per_k = 1e-3;          // so light that the spool does not feel it
  GyroThermalModel model(CoilGeometry{}, {}, design, {1, 5, 10}, 20);
  const auto rate_after = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 10); ++i) model.step(60, 0, false);
    return model.hub_rate_kps();
  };
  const double before = rate_after(20000);
  EXPECT_NEAR(6000 / std::log(before / rate_after(6000)), 6000, 0.01 * 6000);
}

}  // namespace
}  // namespace fogcomp::simulation
