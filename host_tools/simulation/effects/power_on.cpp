// The bias itself, and effects of the time since power-on.

#include <cmath>

#include "simulation/effects/effect.hpp"
#include "simulation/effects/effect_list.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {
namespace {

class Bias : public Effect {
 public:
  Bias(const Parameters& parameters, const EffectContext& context)
      : value_dph_(parameters["value_dph"] +
                   parameters["turn_on_dph"] * Random(context.seed, "bias").gaussian()) {}

  double step(const GyroState&) override { return value_dph_; }

 private:
  double value_dph_;
};

}  // namespace

EffectDescription bias_effect() {
  return {"bias",
          "fixed bias",
          {{"value_dph", "deg/h", 0.5, -1e5, 1e5, "at every temperature"},
           {"turn_on_dph", "deg/h", 0, 0, 1e5, "standard deviation from one seed to the next"}},
          make_effect<Bias>};
}

namespace {

// Share and speed of the source's chip relative to the board.
constexpr double kChipShare = 0.25;
constexpr double kChipSpeed = 8;

// Source and electronics heat themselves after power-on, the chip fast and the board slowly; they
// cool while the power is off, so that a short break causes a small warm-up.
class WarmUp : public Effect {
 public:
  WarmUp(const Parameters& parameters, const EffectContext&)
      : amplitude_dph_(parameters["amplitude_dph"]), tau_s_(parameters["tau_s"]) {}

  double step(const GyroState& state) override {
    if (started_) {
      const double target = state.powered ? 1 : 0;
      board_ += (target - board_) * -std::expm1(-state.step_s / tau_s_);
      chip_ += (target - chip_) * -std::expm1(-state.step_s * kChipSpeed / tau_s_);
    }
    started_ = true;
    return amplitude_dph_ * ((1 - kChipShare) * (1 - board_) + kChipShare * (1 - chip_));
  }

 private:
  double amplitude_dph_;
  double tau_s_;
  double board_ = 0;  ///< fraction of the final self-heating
  double chip_ = 0;
  bool started_ = false;
};

}  // namespace

EffectDescription warm_up_effect() {
  return {"warm_up",
          "decays after every power-on",
          {peak_parameter(),
           scale_parameter(),
           {"amplitude_dph", "deg/h", 0.05, -1e3, 1e3, "at a cold power-on"},
           {"tau_s", "s", 1200, 10, 40000, "time constant of the board"}},
          make_effect<WarmUp>};
}

namespace {

// Creep of the glue (logarithmic) and diffusion of moisture (square root of time), both faster when
// warm (Arrhenius).
class Aging : public Effect {
 public:
  Aging(const Parameters& parameters, const EffectContext&)
      : creep_dph_(parameters["creep_dph"]),
        moisture_dph_(parameters["moisture_dph"]),
        onset_s_(parameters["onset_s"]),
        activation_ev_(parameters["activation_ev"]) {}

  double step(const GyroState& state) override {
    if (state.time_s > 0) {
      age_s_ += state.step_s * arrhenius(activation_ev_, state.thermal->coil_mean_degc());
    }
    return creep_dph_ * std::log10(1 + age_s_ / onset_s_) +
           moisture_dph_ * std::sqrt(age_s_ / 86400);
  }

 private:
  double creep_dph_;
  double moisture_dph_;
  double onset_s_;
  double activation_ev_;
  double age_s_ = 0;  ///< equivalent time at 20 degC
};

}  // namespace

EffectDescription aging_effect() {
  return {"aging",
          "creep and moisture; no power cycle resets them",
          {peak_parameter(),
           scale_parameter(),
           {"creep_dph", "deg/h", 0.01, -1e3, 1e3, "per decade of time"},
           {"moisture_dph", "deg/h", 0.005, -1e3, 1e3, "after the first day, growing as its root"},
           {"onset_s", "s", 3600, 1, 1e8, "start of the logarithm"},
           {"activation_ev", "eV", 0.15, 0, 1.5, "activation energy"}},
          make_effect<Aging>};
}

namespace {

// Mode hops, stick-slip: at random times the bias jumps and returns with a time constant.
class BiasStep : public Effect {
 public:
  BiasStep(const Parameters& parameters, const EffectContext& context)
      : random_(context.seed, "bias_step"),
        size_dph_(parameters["size_dph"]),
        per_hour_(parameters["per_hour"]),
        tau_s_(parameters["tau_s"]),
        next_s_(parameters["first_s"] > 0 ? parameters["first_s"]
                                          : (0.1 + 0.8 * random_.uniform()) * context.duration_s) {}

  double step(const GyroState& state) override {
    if (tau_s_ > 0) level_dph_ *= std::exp(-state.step_s / tau_s_);
    while (state.time_s >= next_s_) {
      const double sign = random_.uniform() < 0.5 ? -1 : 1;
      level_dph_ += sign * size_dph_ * (0.5 + random_.uniform());
      next_s_ += wait_s();
    }
    return level_dph_;
  }

 private:
  double wait_s() {
    return per_hour_ > 0 ? -std::log(1 - random_.uniform()) * 3600 / per_hour_ : 1e18;
  }

  Random random_;
  double size_dph_;
  double per_hour_;
  double tau_s_;
  double next_s_;
  double level_dph_ = 0;
};

}  // namespace

EffectDescription bias_step_effect() {
  return {
      "bias_step",
      "jumps at random times: mode hops, stick-slip; not repeatable in time or temperature",
      {peak_parameter(),
       scale_parameter(),
       {"size_dph", "deg/h", 0.05, 0, 1e4, "typical; each is 0.5 to 1.5 times this, either way"},
       {"per_hour", "1/h", 0.1, 0, 1000, "how often, on average, after the first"},
       {"first_s", "s", 0, 0, 1e9, "time of the first one; 0: somewhere within the programme"},
       {"tau_s", "s", 0, 0, 1e9, "time constant of its decay; 0: it stays"}},
      make_effect<BiasStep>};
}

namespace {

// A loose contact or a source that hops between two modes: two states with random dwell times.
class RandomTelegraph : public Effect {
 public:
  RandomTelegraph(const Parameters& parameters, const EffectContext& context)
      : random_(context.seed, "random_telegraph"),
        height_dph_(parameters["height_dph"]),
        dwell_s_(parameters["dwell_s"]),
        next_s_(wait_s()) {}

  double step(const GyroState& state) override {
    while (state.time_s >= next_s_) {
      up_ = !up_;
      next_s_ += wait_s();
    }
    return up_ ? height_dph_ : 0;
  }

 private:
  double wait_s() { return -std::log(1 - random_.uniform()) * dwell_s_; }

  Random random_;
  double height_dph_;
  double dwell_s_;
  double next_s_;
  bool up_ = true;
};

}  // namespace

EffectDescription random_telegraph_effect() {
  return {"random_telegraph",
          "switches between two levels at random times (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"height_dph", "deg/h", 0.03, -1e4, 1e4, "of the upper level above the lower"},
           {"dwell_s", "s", 1800, 1, 1e6, "mean duration of a level"}},
          make_effect<RandomTelegraph>};
}

namespace {

// A disturbance with its own period: a two-point cooler, a compressor, the supply of another
// instrument. A sine and its second harmonic, independent of power-on and temperature.
class FastCycle : public Effect {
 public:
  FastCycle(const Parameters& parameters, const EffectContext&)
      : amplitude_dph_(parameters["amplitude_dph"]),
        second_(parameters["second"]),
        rad_per_s_(2 * M_PI / parameters["period_s"]),
        phase_rad_(parameters["phase_deg"] * M_PI / 180) {}

  double step(const GyroState& state) override {
    const double phase = rad_per_s_ * state.time_s + phase_rad_;
    return amplitude_dph_ * (std::sin(phase) + second_ * std::sin(2 * phase));
  }

 private:
  double amplitude_dph_;
  double second_;
  double rad_per_s_;
  double phase_rad_;
};

}  // namespace

EffectDescription fast_cycle_effect() {
  return {"fast_cycle",
          "periodic in time, minutes: a cooler or a compressor pulls at the gyro (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"amplitude_dph", "deg/h", 0.01, -1e4, 1e4, "of the first harmonic"},
           {"period_s", "s", 420, 2, 1e5, "of the cycle"},
           {"phase_deg", "deg", 0, -360, 360, "at power-on"},
           {"second", "", 0.2, 0, 1, "share of the second harmonic"}},
          make_effect<FastCycle>};
}

}  // namespace fogcomp::simulation
