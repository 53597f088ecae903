#include <algorithm>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
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

}  // namespace fogcomp::simulation
