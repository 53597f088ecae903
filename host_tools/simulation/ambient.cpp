#include "simulation/ambient.hpp"

#include <cmath>

namespace fogcomp::simulation {
namespace {

constexpr double kEarthHorizontal_ut = 30;
constexpr double kLight_uw = 100;
constexpr double kLightPerK = -1e-3;  ///< fibre and coupler losses, source efficiency
constexpr double kLightPerVolt = 0.05;
constexpr double kLightWander = 0.02;  ///< rms
constexpr double kLightWander_s = 3600;
constexpr double kSupply_v = 5;
constexpr double kSupplyWander_v = 5e-3;  ///< rms
constexpr double kSupplyWander_s = 600;

// One exact step of a first-order Gauss-Markov process.
double wander(double now, double rms, double tau_s, double step_s, Random& random) {
  const double memory = std::exp(-step_s / tau_s);
  return memory * now + rms * std::sqrt(1 - memory * memory) * random.gaussian();
}

}  // namespace

AmbientModel::AmbientModel(std::uint64_t seed)
    : light_random_(seed, "light_power"), supply_random_(seed, "supply") {}

Ambient AmbientModel::step(const ChamberState& chamber, const GyroThermalModel& thermal,
                           double step_s) {
  light_wander_ = wander(light_wander_, kLightWander, kLightWander_s, step_s, light_random_);
  supply_wander_v_ =
      wander(supply_wander_v_, kSupplyWander_v, kSupplyWander_s, step_s, supply_random_);
  const Conditions& conditions = chamber.leg->conditions;
  Ambient ambient;
  ambient[fog::Input::magnetic] =
      kEarthHorizontal_ut * std::cos(conditions.azimuth_deg * M_PI / 180) + conditions.field_ut +
      chamber.stray_field_ut;
  ambient[fog::Input::supply] = kSupply_v + supply_wander_v_;
  ambient[fog::Input::light_power] = kLight_uw * (1 + light_wander_) *
                                     (1 + kLightPerK * (thermal.optics_degc() - 20)) *
                                     (1 + kLightPerVolt * supply_wander_v_);
  ambient[fog::Input::vibration] = chamber.vibration_grms;
  return ambient;
}

}  // namespace fogcomp::simulation
