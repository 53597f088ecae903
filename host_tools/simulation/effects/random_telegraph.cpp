#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/random.hpp"

namespace fogcomp::simulation {
namespace {

// A loose contact or a source that hops between two modes: two states with random dwell times.
class RandomTelegraph : public Effect {
 public:
  RandomTelegraph(const Parameters& parameters, const EffectContext& context)
      : random_(context.seed, "random_telegraph"),
        height_dph_(parameters["height_dph"]),
        dwell_s_(parameters["dwell_s"]),
        next_s_(wait_s()) {}

  double step(const GyroState& state) override {
    while (state.time_s >= next_s_) {
      up_ = !up_;
      next_s_ += wait_s();
    }
    return up_ ? height_dph_ : 0;
  }

 private:
  double wait_s() { return -std::log(1 - random_.uniform()) * dwell_s_; }

  Random random_;
  double height_dph_;
  double dwell_s_;
  double next_s_;
  bool up_ = true;
};

}  // namespace

EffectDescription random_telegraph_effect() {
  return {"random_telegraph",
          "switches between two levels at random times (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"height_dph", "deg/h", 0.03, -1e4, 1e4, "of the upper level above the lower"},
           {"dwell_s", "s", 1800, 1, 1e6, "mean duration of a level"}},
          make_effect<RandomTelegraph>};
}

}  // namespace fogcomp::simulation
