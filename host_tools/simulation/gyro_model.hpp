#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simulation/chamber.hpp"
#include "simulation/effects/effect.hpp"
#include "simulation/gyro_description.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {

/// A temperature sensor: follows the place where it is glued with a lag, and converts once per
/// thermal step, with noise and limited resolution. Its reading is constant between conversions.
class TemperatureSensor {
 public:
  /// `name` of the part: sensor or sensor2.
  TemperatureSensor(const Parameters& parameters, const std::string& name, std::uint64_t seed);

  /// Returns the new reading, degC.
  double step(const GyroThermalModel& thermal, double air_degc, double step_s);

 private:
  double place_degc(const GyroThermalModel& thermal, double air_degc) const;

  Random random_;
  int place_;
  double lag_s_;
  double resolution_k_;
  double noise_k_;
  double offset_k_;
  double element_degc_ = 0;
  bool started_ = false;
};

/// Field, light power, supply and vibration at the gyro. They vary whether or not an effect depends
/// on them, and may be recorded in any case.
class AmbientModel {
 public:
  explicit AmbientModel(std::uint64_t seed);

  Ambient step(const ChamberState& chamber, const GyroThermalModel& thermal, double step_s);

 private:
  Random light_random_;
  Random supply_random_;
  double light_wander_ = 0;
  double supply_wander_v_ = 0;
};

/// Earth rate about the gyro's axis, beside the rate table. Without a latitude it is 0.
struct EarthRate {
  std::optional<double> latitude_deg;
  Axis axis = Axis::up;  ///< unless the profile sets one
};

/// Input rate about the sensitive axis at `time_s`, deg/h.
double input_rate_dph(const Conditions& conditions, double time_s, const EarthRate& earth,
                      Axis axis);

/// All slow processes: chamber, heat flow, effects, sensors; no noise.
class GyroModel {
 public:
  /// At time 0. `programme` must outlive the object. `scales` multiply the effects, in the order of
  /// gyro.effects(); empty: 1.
  GyroModel(const GyroDescription& gyro, const Programme& programme, const EarthRate& earth,
            const ThermalGrid& grid, std::uint64_t seed, std::vector<double> scales = {});
  GyroModel(const GyroModel&) = delete;  // the state contains pointers into the object
  GyroModel& operator=(const GyroModel&) = delete;

  /// Advances by the grid's step.
  void step();

  const GyroState& state() const { return state_; }
  /// deg/h, in the order of gyro.effects().
  const std::vector<double>& contributions_dph() const { return contributions_dph_; }
  /// Input rate plus all contributions.
  double rate_dph() const { return state_.loop_rate_dph; }
  double sensor_degc() const { return sensor_degc_; }

 private:
  void evaluate();

  Chamber chamber_;
  GyroThermalModel thermal_;
  EarthRate earth_;
  bool profile_sets_axis_;
  AmbientModel ambient_;
  TemperatureSensor sensor_;
  TemperatureSensor sensor2_;
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<double> scales_;
  std::vector<double> contributions_dph_;
  GyroState state_;
  double sensor_degc_ = 0;
};

/// Factor of each effect: its `scale`, or the one that gives it the largest magnitude `peak` over
/// the programme, found by one run. Throws InputError for an effect with both, and for one that is
/// always zero and has a peak.
std::vector<double> peak_scales(const GyroDescription& gyro, const Programme& programme,
                                const EarthRate& earth, const ThermalGrid& grid,
                                std::uint64_t seed);

}  // namespace fogcomp::simulation
