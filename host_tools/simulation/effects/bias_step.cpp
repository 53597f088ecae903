#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
