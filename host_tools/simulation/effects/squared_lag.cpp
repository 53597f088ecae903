#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// Non-linear memory: the square of a temperature rate smoothed by two masses in a chain. A fast
// ramp counts more than twice a ramp of half the rate, and cooling counts like heating.
class SquaredLag : public Effect {
 public:
  SquaredLag(const Parameters& parameters, const EffectContext&)
      : coefficient_(parameters["coefficient"]), tau_s_(parameters["tau_s"]) {}

  double step(const GyroState& state) override {
    const double gain = -std::expm1(-state.step_s / tau_s_);
    first_kps_ += gain * (state.thermal->coil_mean_rate_kps() - first_kps_);
    second_kps_ += gain * (first_kps_ - second_kps_);
    const double kpmin = second_kps_ * kSecondsPerMinute;
    return coefficient_ * kpmin * kpmin;
  }

 private:
  double coefficient_;
  double tau_s_;
  double first_kps_ = 0;
  double second_kps_ = 0;
};

}  // namespace

EffectDescription squared_lag_effect() {
  return {"squared_lag",
          "follows the square of a rate that comes late (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/(K/min)^2", 0.1, -1e4, 1e4, "in a long ramp"},
           {"tau_s", "s", 900, 1, 1e5, "of each of the two lags"}},
          make_effect<SquaredLag>};
}

}  // namespace fogcomp::simulation
