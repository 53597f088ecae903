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

}  // namespace fogcomp::simulation
