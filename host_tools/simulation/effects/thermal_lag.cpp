#include "simulation/effects/effect_list.hpp"

#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// A mass inside the spool on an elastic bond presses on the innermost layers as it expands, later
// than the coil. The delay follows from the heat flow (GyroThermalModel's hub, two lumps in a
// chain).
class ThermalLag : public Effect {
 public:
  ThermalLag(const Parameters& parameters, const EffectContext&)
      : coefficient_(parameters["coefficient"] * kSecondsPerMinute) {}

  double step(const GyroState& state) override {
    return coefficient_ * state.thermal->hub_rate_kps();
  }

 private:
  double coefficient_;
};

}  // namespace

EffectDescription thermal_lag_effect() {
  return {"thermal_lag",
          "a rate term that comes late: strain from a mass that follows the coil slowly",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/(K/min)", 0.05, -1e3, 1e3, "in a long ramp"},
           {"tau_s", "s", 400, 10, 20000, "time constant of the mass behind its bond"}},
          make_effect<ThermalLag>,
          [](const Parameters& parameters, GyroThermalDesign& design) {
            design.hub_time_constant_s = parameters["tau_s"];
          }};
}

}  // namespace fogcomp::simulation
