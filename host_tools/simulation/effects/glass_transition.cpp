#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "simulation/effects/stress_kernel.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
