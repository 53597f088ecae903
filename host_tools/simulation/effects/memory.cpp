// Effects of what the gyro went through before: friction, glass, moisture, charge.

#include <algorithm>
#include <cmath>

#include "simulation/coil.hpp"
#include "simulation/effects/effect.hpp"
#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

constexpr int kPlays = 24;

// Prandtl-Ishlinskii: many play operators with exponentially distributed thresholds, like glue
// joints of different strength that slip one after the other.
class ThermalHysteresis : public Effect {
 public:
  ThermalHysteresis(const Parameters& parameters, const EffectContext&) {
    const double typical_k = parameters["threshold_k"];
    double sum = 0;
    for (int i = 0; i < kPlays; ++i) {
      Play play;
      play.threshold_k = 4 * typical_k * (i + 1) / kPlays;
      play.weight = std::exp(-play.threshold_k / typical_k);
      sum += play.weight * 2 * play.threshold_k;
      plays_.push_back(play);
    }
    // A loop much larger than all thresholds has a height of 2 r w at each of them.
    for (Play& play : plays_) play.weight *= parameters["width_dph"] / sum;
  }

  double step(const GyroState& state) override {
    const double degc = state.thermal->coil_mean_degc();
    double bias_dph = 0;
    for (Play& play : plays_) {
      if (!started_) play.output_degc = degc;
      play.output_degc =
          std::clamp(play.output_degc, degc - play.threshold_k, degc + play.threshold_k);
      // Less the temperature itself: single-valued functions belong to the static bias.
      bias_dph += play.weight * (degc - play.output_degc);
    }
    started_ = true;
    return bias_dph;
  }

 private:
  struct Play {
    double threshold_k = 0;
    double weight = 0;  ///< deg/h per K
    double output_degc = 0;
  };

  std::vector<Play> plays_;
  bool started_ = false;
};

}  // namespace

EffectDescription thermal_hysteresis_effect() {
  return {"thermal_hysteresis",
          "the bias at a temperature depends on the turning points before it, not on the rate",
          {peak_parameter(),
           scale_parameter(),
           {"width_dph", "deg/h", 0.03, 0, 1e3, "of a full loop, warming less cooling branch"},
           {"threshold_k", "K", 6, 0.5, 60, "typical reversal that moves the bias"}},
          make_effect<ThermalHysteresis>};
}

namespace {

// A material freezes at the transition where its structure relaxes in about 100 s (the usual
// definition of the glass transition): in fast ramps the transition is shifted. A part continues to
// relax in the glass for hours.
constexpr double kRelaxation_s = 150;
constexpr double kSlowRelaxation_s = 5400;
constexpr double kSlowShare = 0.2;

// Each layer of the potting freezes separately: the frozen share follows its equilibrium value with
// a lag.
class GlassTransition : public Effect {
 public:
  GlassTransition(const Parameters& parameters, const EffectContext& context)
      : tg_degc_(parameters["tg_degc"]),
        width_k_(parameters["width_k"]),
        step_dph_(parameters["step_dph"]),
        kernel_(parameters["rate_term"] * unit_stress_kernel(context.coil_error)) {}

  double step(const GyroState& state) override {
    const CellArray target = state.thermal->coil_degc().unaryExpr(
        [this](double degc) { return 0.5 * std::erfc((degc - tg_degc_) / (M_SQRT2 * width_k_)); });
    if (fast_.size() == 0) fast_ = slow_ = target;
    fast_ -= std::expm1(-state.step_s / kRelaxation_s) * (target - fast_);
    slow_ -= std::expm1(-state.step_s / kSlowRelaxation_s) * (target - slow_);
    const CellArray frozen = (1 - kSlowShare) * fast_ + kSlowShare * slow_;
    return step_dph_ * frozen.mean() + (kernel_ * frozen * state.thermal->coil_rate_kps()).sum();
  }

 private:
  double tg_degc_;
  double width_k_;
  double step_dph_;
  CellArray kernel_;
  CellArray fast_;  ///< frozen fraction of each cell, 0 to 1
  CellArray slow_;
};

}  // namespace

EffectDescription glass_transition_effect() {
  return {"glass_transition",
          "potting turns from rubber to glass: a step of the bias, and another rate term below",
          {peak_parameter(),
           scale_parameter(),
           {"tg_degc", "degC", -20, -90, 140, "where half of it has frozen in a slow ramp"},
           {"width_k", "K", 4, 0.2, 40, "standard deviation over the potting"},
           {"step_dph", "deg/h", 0.03, -1e3, 1e3, "glassy less rubbery"},
           {"rate_term", "deg/h/(K/min)", 0.03, -1e3, 1e3, "added to the rate term when glassy"}},
          make_effect<GlassTransition>};
}

namespace {

// Glue that continues to cure, or a joint that settles, whenever the coil gets warmer than ever
// before; irreversible.
class WarmestSoFar : public Effect {
 public:
  WarmestSoFar(const Parameters& parameters, const EffectContext&)
      : dph_per_k_(parameters["coefficient"]),
        onset_degc_(parameters["onset_degc"]),
        warmest_degc_(onset_degc_) {}

  double step(const GyroState& state) override {
    warmest_degc_ = std::max(warmest_degc_, state.thermal->coil_mean_degc());
    return dph_per_k_ * (warmest_degc_ - onset_degc_);
  }

 private:
  double dph_per_k_;
  double onset_degc_;
  double warmest_degc_;
};

}  // namespace

EffectDescription warmest_so_far_effect() {
  return {"warmest_so_far",
          "moves for good whenever the coil gets warmer than ever before (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/K", 1e-3, -10, 10, "per kelvin of a new record"},
           {"onset_degc", "degC", 20, -100, 150, "warmest before the test"}},
          make_effect<WarmestSoFar>};
}

namespace {

constexpr double kStartDegc = 20;  // long before the test

// Potting gives off moisture when warm and takes it up again when cold: a lag behind the
// temperature that is slow in the cold (Arrhenius), so that heating and cooling differ.
class MoistureExchange : public Effect {
 public:
  MoistureExchange(const Parameters& parameters, const EffectContext&)
      : dph_per_k_(parameters["coefficient"]),
        tau_s_(parameters["tau_s"]),
        activation_ev_(parameters["activation_ev"]) {}

  double step(const GyroState& state) override {
    const double degc = state.thermal->coil_mean_degc();
    const double steps = state.step_s / tau_s_ * arrhenius(activation_ev_, degc);
    dry_k_ -= std::expm1(-steps) * (degc - kStartDegc - dry_k_);
    return dph_per_k_ * dry_k_;
  }

 private:
  double dph_per_k_;
  double tau_s_;
  double activation_ev_;
  double dry_k_ = 0;  // what has left, in kelvin above 20 degC at which it would rest
};

}  // namespace

EffectDescription moisture_exchange_effect() {
  return {"moisture_exchange",
          "moisture leaves the potting when warm and comes back when cold (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/K", 1e-3, -10, 10, "at rest, per kelvin above 20 degC"},
           {"tau_s", "s", 7200, 1, 1e7, "time constant at 20 degC"},
           {"activation_ev", "eV", 0.4, 0, 1.5, "activation energy of the diffusion"}},
          make_effect<MoistureExchange>};
}

namespace {

// Charge leaks faster when warm: a decade per this many kelvin (lithium niobate, order of
// magnitude).
constexpr double kLeakDecade_k = 60;

// Lithium niobate is charged by temperature changes; above a threshold the waveguide loses light,
// and the bias shifts until the charge has leaked away.
class Pyroelectric : public Effect {
 public:
  Pyroelectric(const Parameters& parameters, const EffectContext&)
      : dph_per_k_(parameters["coefficient"]),
        threshold_k_(parameters["threshold_k"]),
        leak_s_(parameters["leak_s"]) {}

  double step(const GyroState& state) override {
    const double degc = state.thermal->optics_degc();
    if (started_) charge_k_ += degc - before_degc_;
    before_degc_ = degc;
    started_ = true;
    const double tau_s = leak_s_ * std::pow(10.0, (20 - degc) / kLeakDecade_k);
    charge_k_ *= std::exp(-state.step_s / tau_s);
    return dph_per_k_ * std::max(std::abs(charge_k_) - threshold_k_, 0.0);
  }

 private:
  double dph_per_k_;
  double threshold_k_;
  double leak_s_;
  double charge_k_ = 0;  ///< in kelvin of fast temperature change
  double before_degc_ = 0;
  bool started_ = false;
};

}  // namespace

EffectDescription pyroelectric_effect() {
  return {"pyroelectric",
          "charge in the integrated optics after fast changes in the cold (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/K", 0.01, -1e3, 1e3, "per kelvin of charge above the threshold"},
           {"threshold_k", "K", 5, 0, 100, "charge that does no harm"},
           {"leak_s", "s", 200, 1, 1e6, "time constant of the leakage at 20 degC"}},
          make_effect<Pyroelectric>};
}

}  // namespace fogcomp::simulation
