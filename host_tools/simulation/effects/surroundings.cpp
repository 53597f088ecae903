// Effects of field, vibration, light and polarisation.

#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

// Faraday effect in a twisted fibre: the field in the coil's plane times a sensitivity that depends
// on the gyro's azimuth (relative to the field in ambient) and temperature.
class Magnetic : public Effect {
 public:
  Magnetic(const Parameters& parameters, const EffectContext&)
      : dph_per_ut_(parameters["sensitivity"]), per_k_(parameters["temperature_slope"]) {}

  double step(const GyroState& state) override {
    const double above_k = state.thermal->coil_mean_degc() - kReference_degc;
    return dph_per_ut_ * state.ambient[fog::Input::magnetic] * (1 + per_k_ * above_k);
  }

 private:
  double dph_per_ut_;
  double per_k_;
};

}  // namespace

EffectDescription magnetic_effect() {
  return {"magnetic",
          "Faraday effect of the field in the coil's plane; --columns magnetic records the field",
          {peak_parameter(),
           scale_parameter(),
           {"sensitivity", "deg/h/uT", 6e-4, -10, 10, "0.03 deg/h in the Earth's 50 uT: shielded"},
           {"temperature_slope", "1/K", 2e-3, -0.1, 0.1, "relative change of the sensitivity"}},
          make_effect<Magnetic>};
}

namespace {

// Dampers and glue stiffen when cold and transmit less.
constexpr double kDamping_per_k = 3e-3;

// Vibration modulates power and phase together; their product has a non-zero mean.
class Vibration : public Effect {
 public:
  Vibration(const Parameters& parameters, const EffectContext&)
      : dph_per_g2_(parameters["coefficient"]) {}

  double step(const GyroState& state) override {
    const double g = state.ambient[fog::Input::vibration];
    const double above_k = state.thermal->cover_degc() - kReference_degc;
    return dph_per_g2_ * g * g * (1 + kDamping_per_k * above_k);
  }

 private:
  double dph_per_g2_;
};

}  // namespace

EffectDescription vibration_effect() {
  return {"vibration",
          "vibration rectification, k g^2; --columns vibration records g",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/g^2", 0.02, -1e4, 1e4, "at 20 degC"}},
          make_effect<Vibration>};
}

namespace {

// The less light, the more a fixed electronic offset in the demodulated signal matters.
class LightPower : public Effect {
 public:
  LightPower(const Parameters& parameters, const EffectContext&)
      : pickup_dph_(parameters["pickup_dph"]), nominal_uw_(parameters["nominal_uw"]) {}

  double step(const GyroState& state) override {
    return pickup_dph_ * (nominal_uw_ / state.ambient[fog::Input::light_power] - 1);
  }

 private:
  double pickup_dph_;
  double nominal_uw_;
};

}  // namespace

EffectDescription light_power_effect() {
  return {"light_power",
          "electronic pick-up weighs more with less light; --columns light_power records the power",
          {peak_parameter(),
           scale_parameter(),
           {"pickup_dph", "deg/h", 0.1, -1e3, 1e3, "of the pick-up at nominal power"},
           {"nominal_uw", "uW", 100, 0.1, 1e5, "power at which the pick-up is trimmed"}},
          make_effect<LightPower>};
}

namespace {

// Birefringence is not linear in temperature: coefficients of -5.3e-7 to -5.9e-7 /K have been
// measured, a change of about 10 % over a wide range.
constexpr double kChirp_per_k = 5e-4;
constexpr double kSecondPeriodRatio = 0.37;

// Two pieces of birefringent fibre in the coil's pigtails act as interferometers for the light that
// the polariser passes in the wrong axis.
class PolarizationRipple : public Effect {
 public:
  PolarizationRipple(const Parameters& parameters, const EffectContext&)
      : amplitude_dph_(parameters["amplitude_dph"]),
        second_(parameters["second"]),
        turns_per_k_(1 / parameters["period_k"]),
        phase_rad_(parameters["phase_deg"] * M_PI / 180) {}

  double step(const GyroState& state) override {
    const double above_k = state.thermal->coil_mean_degc() - kReference_degc;
    const double turns = turns_per_k_ * above_k * (1 + kChirp_per_k * above_k);
    return amplitude_dph_ * (std::cos(2 * M_PI * turns + phase_rad_) +
                             second_ * std::cos(2 * M_PI * turns / kSecondPeriodRatio + 1.0));
  }

 private:
  double amplitude_dph_;
  double second_;
  double turns_per_k_;
  double phase_rad_;
};

}  // namespace

EffectDescription polarization_ripple_effect() {
  return {"polarization_ripple",
          "interference of cross-coupled light: periodic in temperature, not in time",
          {peak_parameter(),
           scale_parameter(),
           {"amplitude_dph", "deg/h", 0.01, 0, 1e3, "of the main ripple"},
           {"period_k", "K", 13, 0.5, 200, "13 K for 0.2 m of birefringent path"},
           {"phase_deg", "deg", 40, -360, 360, "at 20 degC"},
           {"second", "", 0.15, 0, 1, "share of a second ripple, 0.37 times the period"}},
          make_effect<PolarizationRipple>};
}

namespace {

constexpr double kSpeedOfLight_mps = 299792458.0;

// The modulation clock is constant, but the coil's proper frequency c / (2 n L) changes with
// temperature; pick-up synchronous with the modulation turns the difference into a bias.
class ProperFrequency : public Effect {
 public:
  ProperFrequency(const Parameters& parameters, const EffectContext& context)
      : dph_per_hz_(parameters["coefficient"]), detuning_hz_(parameters["detuning_hz"]) {
    const FibreMaterial& material = context.coil_error.material();
    const double optical_path_m =
        material.refractive_index * context.coil_error.coil().fibre_length_m();
    hz_per_k_ = -kSpeedOfLight_mps / (2 * optical_path_m) * material.thermal_phase_per_k() /
                material.refractive_index;
  }

  double step(const GyroState& state) override {
    const double above_k = state.thermal->coil_mean_degc() - kReference_degc;
    return dph_per_hz_ * (detuning_hz_ - hz_per_k_ * above_k);
  }

 private:
  double dph_per_hz_;
  double detuning_hz_;
  double hz_per_k_;
};

}  // namespace

EffectDescription proper_frequency_effect() {
  return {"proper_frequency",
          "modulation off the coil's proper frequency, which falls 0.8 Hz/K (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/Hz", 2e-4, -10, 10, "size of the synchronous pick-up"},
           {"detuning_hz", "Hz", 0, -1e4, 1e4, "clock less proper frequency at 20 degC"}},
          make_effect<ProperFrequency>};
}

}  // namespace fogcomp::simulation
