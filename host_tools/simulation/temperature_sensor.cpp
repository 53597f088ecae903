#include "simulation/temperature_sensor.hpp"

#include <cmath>

namespace fogcomp::simulation {

TemperatureSensor::TemperatureSensor(const Parameters& parameters, const std::string& name,
                                     std::uint64_t seed)
    : random_(seed, name),
      place_(static_cast<int>(parameters["at"])),
      lag_s_(parameters["lag_s"]),
      resolution_k_(parameters["resolution_k"]),
      noise_k_(parameters["noise_k"]),
      offset_k_(parameters["offset_k"]) {}

double TemperatureSensor::place_degc(const GyroThermalModel& thermal, double air_degc) const {
  switch (place_) {
    case 0:
      return thermal.coil_outside_degc();
    case 1:
      return thermal.lower_flange_degc();
    case 2:
      return thermal.cover_degc();
    default:
      return air_degc;
  }
}

double TemperatureSensor::step(const GyroThermalModel& thermal, double air_degc, double step_s) {
  const double place = place_degc(thermal, air_degc);
  if (!started_) element_degc_ = place;
  started_ = true;
  const double share = lag_s_ > 0 ? -std::expm1(-step_s / lag_s_) : 1;
  element_degc_ += share * (place - element_degc_);
  const double converted = element_degc_ + offset_k_ + noise_k_ * random_.gaussian();
  return resolution_k_ > 0 ? resolution_k_ * std::round(converted / resolution_k_) : converted;
}

}  // namespace fogcomp::simulation
