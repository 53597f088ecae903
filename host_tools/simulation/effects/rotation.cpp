// Effects of the rotation: scale factor, closed loop, and the record of the rate table.

#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// The loop divides by a gain that was calibrated as 1.
class ScaleFactor : public Effect {
 public:
  ScaleFactor(const Parameters& parameters, const EffectContext&)
      : gain_(1 - parameters["ppm"] * 1e-6) {}

  double step(const GyroState& state) override {
    return state.input_rate_dph / gain_ - state.input_rate_dph;
  }

 private:
  double gain_;
};

}  // namespace

EffectDescription scale_factor_effect() {
  return {
      "scale_factor",
      "what the calibration left of the scale factor; needs an input rate",
      {peak_parameter(), scale_parameter(), {"ppm", "ppm", 100, -1e5, 1e5, "of the input rate"}},
      make_effect<ScaleFactor>};
}

namespace {

// Scale factor ~ L D / wavelength. The source's mean wavelength follows its temperature, which its
// cooler controls less accurately away from 20 degC; the coil expands with its own temperature.
class ScaleFactorTemperature : public Effect {
 public:
  ScaleFactorTemperature(const Parameters& parameters, const EffectContext&)
      : wavelength_per_k_(parameters["wavelength_ppm"] * 1e-6),
        coil_per_k_(parameters["coil_ppm"] * 1e-6) {}

  double step(const GyroState& state) override {
    const double source_k = state.thermal->optics_degc() - kReference_degc;
    const double coil_k = state.thermal->coil_mean_degc() - kReference_degc;
    const double length_ratio =
        (1 + coil_per_k_ * coil_k) / (1 + wavelength_per_k_ * source_k * (1 + 2e-3 * source_k));
    return state.input_rate_dph * (length_ratio - 1);
  }

 private:
  double wavelength_per_k_;
  double coil_per_k_;
};

}  // namespace

EffectDescription scale_factor_temperature_effect() {
  return {"scale_factor_temperature",
          "source wavelength and coil size change the scale factor; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"wavelength_ppm", "ppm/K", 5, -1000, 1000, "of the source's mean wavelength"},
           {"coil_ppm", "ppm/K", 4, -1000, 1000, "of length times diameter"}},
          make_effect<ScaleFactorTemperature>};
}

namespace {

// An open loop outputs the sine of the Sagnac phase; the effect is its deviation from a
// least-squares straight line. An offset of the bias point makes it asymmetric. For small phases a
// this is -a^2 / 15 of Legendre's third polynomial and a / 3 tan(offset) of the second.
class ScaleFactorNonlinearity : public Effect {
 public:
  ScaleFactorNonlinearity(const Parameters& parameters, const EffectContext&)
      : full_scale_dph_(parameters["full_scale_dps"] * kDphPerDegreePerSecond),
        sign_(std::copysign(1, parameters["ppm"])),
        phase_(std::sqrt(15e-6 * std::abs(parameters["ppm"]))),
        offset_(std::atan(3e-6 * sign_ * parameters["even_ppm"] / std::max(phase_, 1e-9))),
        slope_(phase_ > 1e-3
                   ? 3 * (std::sin(phase_) - phase_ * std::cos(phase_)) / std::pow(phase_, 3)
                   : 1) {}

  double step(const GyroState& state) override {
    if (phase_ == 0) return 0;
    const double u = state.input_rate_dph / full_scale_dph_;
    const double shown =
        (std::sin(phase_ * u + offset_) - std::sin(offset_)) / (phase_ * std::cos(offset_));
    return -sign_ * full_scale_dph_ * (shown - slope_ * u);
  }

 private:
  double full_scale_dph_;
  double sign_;
  double phase_;  // at full scale
  double offset_;
  double slope_;
};

}  // namespace

EffectDescription scale_factor_nonlinearity_effect() {
  return {"scale_factor_nonlinearity",
          "sine of an open loop behind its linearisation; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"ppm", "ppm", 300, -1e5, 1e5, "of full scale, odd"},
           {"even_ppm", "ppm", 0, -1e4, 1e4, "of full scale, even"},
           {"full_scale_dps", "deg/s", 100, 0.01, 1000, "rate of that phase"}},
          make_effect<ScaleFactorNonlinearity>};
}

namespace {

// The two ramps of the closed loop differ in gain; near zero its noise mixes them, which rounds the
// corner to a hyperbola.
class ScaleFactorAsymmetry : public Effect {
 public:
  ScaleFactorAsymmetry(const Parameters& parameters, const EffectContext&)
      : difference_(parameters["ppm"] * 1e-6),
        rounded_dph_(parameters["rounded_dps"] * kDphPerDegreePerSecond) {}

  double step(const GyroState& state) override {
    return difference_ * (std::hypot(state.input_rate_dph, rounded_dph_) - rounded_dph_);
  }

 private:
  double difference_;
  double rounded_dph_;
};

}  // namespace

EffectDescription scale_factor_asymmetry_effect() {
  return {"scale_factor_asymmetry",
          "gain that differs with the sense of rotation; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"ppm", "ppm", 20, -1e5, 1e5, "half of the difference"},
           {"rounded_dps", "deg/s", 0.01, 1e-6, 100, "width of the rounded corner"}},
          make_effect<ScaleFactorAsymmetry>};
}

namespace {

constexpr double kSpan_k = 40;  ///< above and below the reference, where T^2 counts as 1

enum class Form { magnitude, square, temperature_squared };

// Terms of an expansion in T and dT/dt without a physical effect of the catalogue.
class RateNonlinearity : public Effect {
 public:
  RateNonlinearity(const Parameters& parameters, const EffectContext&)
      : coefficient_(parameters["coefficient"]), form_(static_cast<Form>(parameters["form"])) {}

  double step(const GyroState& state) override {
    const double kpmin = state.thermal->coil_mean_rate_kps() * kSecondsPerMinute;
    const double place = (state.thermal->coil_mean_degc() - kReference_degc) / kSpan_k;
    switch (form_) {
      case Form::magnitude:
        return coefficient_ * std::abs(kpmin);
      case Form::square:
        return coefficient_ * kpmin * kpmin;
      case Form::temperature_squared:
        break;
    }
    return coefficient_ * place * place * kpmin;
  }

 private:
  double coefficient_;
  Form form_;
};

}  // namespace

EffectDescription rate_nonlinearity_effect() {
  return {"rate_nonlinearity",
          "|dT/dt|, (dT/dt)^2 or (T - 20)^2 dT/dt (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h", 0.05, -1e4, 1e4, "at 1 K/min, for the last also 60 degC"},
           {"form", "", 0, 0, 0, "which", {"magnitude", "square", "temperature_squared"}}},
          make_effect<RateNonlinearity>};
}

namespace {

// The modulator's half-wave voltage changes with temperature. The second closed loop corrects the 2
// pi reset slowly and incompletely; the remainder is a scale factor error.
class HalfWaveVoltage : public Effect {
 public:
  HalfWaveVoltage(const Parameters& parameters, const EffectContext&)
      : per_k_(parameters["half_wave_ppm"] * 1e-6),
        loop_tau_s_(parameters["loop_tau_s"]),
        left_(parameters["left"]) {}

  double step(const GyroState& state) override {
    const double degc = state.thermal->optics_degc();
    if (!started_) tracked_degc_ = degc;
    started_ = true;
    tracked_degc_ += (degc - tracked_degc_) * -std::expm1(-state.step_s / loop_tau_s_);
    const double error = per_k_ * ((degc - tracked_degc_) + left_ * (degc - 20));
    return state.input_rate_dph * error;
  }

 private:
  double per_k_;
  double loop_tau_s_;
  double left_;
  double tracked_degc_ = 0;
  bool started_ = false;
};

}  // namespace

EffectDescription half_wave_voltage_effect() {
  return {"half_wave_voltage",
          "2 pi reset error behind the second loop; needs an input rate (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"half_wave_ppm", "ppm/K", 500, -5000, 5000, "of the modulator's half-wave voltage"},
           {"loop_tau_s", "s", 10, 0.1, 1e5, "time constant of the second loop"},
           {"left", "", 2e-3, 0, 1, "share of the change that the loop never corrects"}},
          make_effect<HalfWaveVoltage>};
}

namespace {

double normal_density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2 * M_PI);
}

double normal_probability(double x) {
  return 0.5 * std::erfc(-x / M_SQRT2);
}

// The closed loop locks to zero while its rate is within the band. Dither (or the loop's own noise)
// exceeds the band part of the time: the mean output is the rate less the mean of the locked part,
// in closed form for Gaussian dither.
class DeadBand : public Effect {
 public:
  DeadBand(const Parameters& parameters, const EffectContext&)
      : half_width_dph_(parameters["half_width_dph"]), dither_dph_(parameters["dither_dph"]) {}

  double step(const GyroState& state) override {
    const double rate = state.loop_rate_dph;
    const double low = (-half_width_dph_ - rate) / dither_dph_;
    const double high = (half_width_dph_ - rate) / dither_dph_;
    return -rate * (normal_probability(high) - normal_probability(low)) +
           dither_dph_ * (normal_density(high) - normal_density(low));
  }

 private:
  double half_width_dph_;
  double dither_dph_;
};

}  // namespace

EffectDescription dead_band_effect() {
  return {"dead_band",
          "the loop locks near zero rate (simulator only)",
          {{"half_width_dph", "deg/h", 0.05, 1e-6, 100, "rates below this are locked"},
           {"dither_dph", "deg/h", 0.02, 1e-6, 1e4, "rms of the dither that unlocks the loop"}},
          make_effect<DeadBand>};
}

namespace {

constexpr double kSecondsPerMs = 1e-3;

// The record at time t shows the table at t - delay; the true rotation is ahead by the delay. Only
// in sweeps; a step of the table falls between two of the simulator's steps.
class LateReference : public Effect {
 public:
  LateReference(const Parameters& parameters, const EffectContext&)
      : delay_s_(parameters["delay_ms"] * kSecondsPerMs) {}

  double step(const GyroState& state) override {
    const Conditions& table = state.chamber->leg->conditions;
    return table_rate_dph(table, state.time_s + delay_s_) - table_rate_dph(table, state.time_s);
  }

 private:
  double delay_s_;
};

}  // namespace

EffectDescription late_reference_effect() {
  return {
      "late_reference",
      "the table's record is late: a fault of the recording; needs a profile with a sweep",
      {peak_parameter(), scale_parameter(), {"delay_ms", "ms", 20, -1000, 1000, "of the record"}},
      make_effect<LateReference>};
}

}  // namespace fogcomp::simulation
