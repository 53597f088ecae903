#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

double normal_density(double x) {
  return std::exp(-0.5 * x * x) / std::sqrt(2 * M_PI);
}

double normal_probability(double x) {
  return 0.5 * std::erfc(-x / M_SQRT2);
}

// The closed loop locks to zero while its rate is within the band. Dither (or the loop's own noise)
// exceeds the band part of the time: the mean output is the rate less the mean of the locked part,
// in closed form for Gaussian dither.
class DeadBand : public Effect {
 public:
  DeadBand(const Parameters& parameters, const EffectContext&)
      : half_width_dph_(parameters["half_width_dph"]), dither_dph_(parameters["dither_dph"]) {}

  double step(const GyroState& state) override {
    const double rate = state.loop_rate_dph;
    const double low = (-half_width_dph_ - rate) / dither_dph_;
    const double high = (half_width_dph_ - rate) / dither_dph_;
    return -rate * (normal_probability(high) - normal_probability(low)) +
           dither_dph_ * (normal_density(high) - normal_density(low));
  }

 private:
  double half_width_dph_;
  double dither_dph_;
};

}  // namespace

EffectDescription dead_band_effect() {
  return {"dead_band",
          "the loop locks near zero rate (simulator only)",
          {{"half_width_dph", "deg/h", 0.05, 1e-6, 100, "rates below this are locked"},
           {"dither_dph", "deg/h", 0.02, 1e-6, 1e4, "rms of the dither that unlocks the loop"}},
          make_effect<DeadBand>};
}

}  // namespace fogcomp::simulation
