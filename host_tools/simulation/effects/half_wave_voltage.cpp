#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
