#include "simulation/gyro_model.hpp"

#include <algorithm>
#include <cmath>

#include "support/input_error.hpp"

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

constexpr double kEarthRate_dph = 15.041067;

// Component of the Earth's rotation along an axis.
double earth_rate_dph(double latitude_deg, Axis axis) {
  const double latitude_rad = latitude_deg * M_PI / 180;
  switch (axis) {
    case Axis::up:
      return kEarthRate_dph * std::sin(latitude_rad);
    case Axis::down:
      return -kEarthRate_dph * std::sin(latitude_rad);
    case Axis::north:
      return kEarthRate_dph * std::cos(latitude_rad);
    case Axis::south:
      return -kEarthRate_dph * std::cos(latitude_rad);
    case Axis::east:
    case Axis::west:
      break;
  }
  return 0;
}

std::vector<std::unique_ptr<Effect>> make_effects(const GyroDescription& gyro,
                                                  const GyroThermalModel& thermal,
                                                  double duration_s, std::uint64_t seed) {
  const CoilError coil_error(gyro.coil(), FibreMaterial{},
                             static_cast<int>(thermal.coil_degc().cols()));
  const EffectContext context{coil_error, duration_s, seed};
  std::vector<std::unique_ptr<Effect>> effects;
  for (const auto& active : gyro.effects()) {
    effects.push_back(active.description->make(active.parameters, context));
  }
  return effects;
}

}  // namespace

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

double input_rate_dph(const Conditions& conditions, double time_s, const EarthRate& earth,
                      Axis axis) {
  return table_rate_dph(conditions, time_s) +
         (earth.latitude_deg ? earth_rate_dph(*earth.latitude_deg, axis) : 0);
}

GyroModel::GyroModel(const GyroDescription& gyro, const Programme& programme,
                     const EarthRate& earth, const ThermalGrid& grid, std::uint64_t seed,
                     std::vector<double> scales)
    : chamber_(programme, grid.step_s, seed),
      thermal_(gyro.coil(), FibreMaterial{}, gyro.thermal_design(), grid, programme.start_degc),
      earth_(earth),
      profile_sets_axis_(programme.sets_axis),
      ambient_(seed),
      sensor_(gyro.part("sensor"), "sensor", seed),
      sensor2_(gyro.part("sensor2"), "sensor2", seed),
      effects_(make_effects(gyro, thermal_, programme.duration_s(), seed)),
      scales_(std::move(scales)),
      contributions_dph_(effects_.size(), 0) {
  scales_.resize(effects_.size(), 1);
  state_.step_s = grid.step_s;
  evaluate();
}

void GyroModel::step() {
  chamber_.step();
  const Conditions& conditions = chamber_.state().leg->conditions;
  thermal_.step(chamber_.state().air_degc, conditions.heater_w, conditions.powered);
  evaluate();
}

void GyroModel::evaluate() {
  const ChamberState& chamber = chamber_.state();
  const Conditions& conditions = chamber.leg->conditions;
  state_.time_s = chamber.time_s;
  state_.powered = conditions.powered;
  state_.chamber = &chamber;
  state_.thermal = &thermal_;
  state_.ambient = ambient_.step(chamber, thermal_, state_.step_s);
  state_.input_rate_dph = input_rate_dph(conditions, state_.time_s, earth_,
                                         profile_sets_axis_ ? conditions.axis : earth_.axis);
  state_.loop_rate_dph = state_.input_rate_dph;
  for (std::size_t i = 0; i < effects_.size(); ++i) {
    contributions_dph_[i] = scales_[i] * effects_[i]->step(state_);
    state_.loop_rate_dph += contributions_dph_[i];
  }
  sensor_degc_ = sensor_.step(thermal_, chamber.air_degc, state_.step_s);
  state_.ambient[fog::Input::temperature2] =
      sensor2_.step(thermal_, chamber.air_degc, state_.step_s);
}

namespace {

// The given scale of each effect, else 1, and the given peak, else 0.
struct Sizes {
  std::vector<double> scales;
  std::vector<double> peaks;
};

Sizes wanted_sizes(const GyroDescription& gyro) {
  const auto& effects = gyro.effects();
  Sizes sizes{std::vector<double>(effects.size(), 1), std::vector<double>(effects.size(), 0)};
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const Parameters& parameters = effects[i].parameters;
    if (parameters.was_set("scale")) sizes.scales[i] = parameters["scale"];
    if (parameters.was_set("peak")) sizes.peaks[i] = parameters["peak"];
    if (sizes.peaks[i] > 0 && parameters.was_set("scale")) {
      throw InputError("effect " + effects[i].description->name,
                       "has both peak= and scale=; give one of them");
    }
  }
  return sizes;
}

}  // namespace

std::vector<double> peak_scales(const GyroDescription& gyro, const Programme& programme,
                                const EarthRate& earth, const ThermalGrid& grid,
                                std::uint64_t seed) {
  const auto& effects = gyro.effects();
  auto [scales, wanted] = wanted_sizes(gyro);
  if (std::none_of(wanted.begin(), wanted.end(), [](double peak) { return peak > 0; })) {
    return scales;
  }
  GyroModel model(gyro, programme, earth, grid, seed);
  std::vector<double> largest(effects.size(), 0);
  const auto steps = static_cast<std::size_t>(std::ceil(programme.duration_s() / grid.step_s));
  for (std::size_t step = 0;; ++step) {
    for (std::size_t i = 0; i < effects.size(); ++i) {
      if (model.state().powered) {
        largest[i] = std::max(largest[i], std::abs(model.contributions_dph()[i]));
      }
    }
    if (step == steps) break;
    model.step();
  }
  for (std::size_t i = 0; i < effects.size(); ++i) {
    if (wanted[i] == 0) continue;
    if (largest[i] < 1e-12) {
      throw InputError("effect " + effects[i].description->name,
                       "stays zero over this programme, so that it has no peak to scale; choose "
                       "another profile or, for effects of the input rate, --latitude");
    }
    scales[i] = wanted[i] / largest[i];
  }
  return scales;
}

}  // namespace fogcomp::simulation
