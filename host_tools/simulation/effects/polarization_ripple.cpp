#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
