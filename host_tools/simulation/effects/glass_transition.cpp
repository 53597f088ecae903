#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "simulation/effects/stress_kernel.hpp"

namespace fogcomp::simulation {
namespace {

// Structural relaxation slows by a decade for each of these below the transition (effective value
// for epoxies in the Tool-Narayanaswamy picture), so that fast ramps meet it shifted.
constexpr double kDecade_k = 3;
constexpr double kRelaxation_s = 100;  ///< at the transition: its usual definition
constexpr double kSlowest_s = 3 * 3600.0;

// Each layer of the potting freezes on its own: the frozen share follows its equilibrium value with
// a time constant that depends on temperature.
class GlassTransition : public Effect {
 public:
  GlassTransition(const Parameters& parameters, const EffectContext& context)
      : tg_degc_(parameters["tg_degc"]),
        width_k_(parameters["width_k"]),
        step_dph_(parameters["step_dph"]),
        kernel_(parameters["rate_term"] * unit_stress_kernel(context.coil_error)) {}

  double step(const GyroState& state) override {
    const CellArray& degc = state.thermal->coil_degc();
    if (frozen_.size() == 0) {
      frozen_ = degc.unaryExpr([this](double t) { return equilibrium(t); });
    }
    for (Eigen::Index i = 0; i < frozen_.size(); ++i) {
      const double t = degc(i);
      const double time_constant_s =
          std::min(kRelaxation_s * std::pow(10.0, (tg_degc_ - t) / kDecade_k), kSlowest_s);
      frozen_(i) += (equilibrium(t) - frozen_(i)) * -std::expm1(-state.step_s / time_constant_s);
    }
    return step_dph_ * frozen_.mean() + (kernel_ * frozen_ * state.thermal->coil_rate_kps()).sum();
  }

 private:
  double equilibrium(double degc) const {
    return 0.5 * std::erfc((degc - tg_degc_) / (M_SQRT2 * width_k_));
  }

  double tg_degc_;
  double width_k_;
  double step_dph_;
  CellArray kernel_;
  CellArray frozen_;
};

}  // namespace

EffectDescription glass_transition_effect() {
  return {"glass_transition",
          "potting turns from rubber to glass: a step of the bias, and another rate term below",
          {peak_parameter(),
           {"tg_degc", "degC", -20, -90, 140, "where half of it has frozen in a slow ramp"},
           {"width_k", "K", 4, 0.2, 40, "standard deviation over the potting"},
           {"step_dph", "deg/h", 0.03, -1e3, 1e3, "glassy less rubbery"},
           {"rate_term", "deg/h/(K/min)", 0.03, -1e3, 1e3, "added to the rate term when glassy"}},
          make_effect<GlassTransition>};
}

}  // namespace fogcomp::simulation
