#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
