#include <algorithm>
#include <cmath>

#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {
namespace {

constexpr int kPlays = 24;

// Prandtl-Ishlinskii: many play operators with exponentially distributed thresholds, like glue
// joints of different strength that slip one after the other.
class ThermalHysteresis : public Effect {
 public:
  ThermalHysteresis(const Parameters& parameters, const EffectContext&) {
    const double typical_k = parameters["threshold_k"];
    double sum = 0;
    for (int i = 0; i < kPlays; ++i) {
      Play play;
      play.threshold_k = 4 * typical_k * (i + 1) / kPlays;
      play.weight = std::exp(-play.threshold_k / typical_k);
      sum += play.weight * 2 * play.threshold_k;
      plays_.push_back(play);
    }
    // A loop much larger than all thresholds has a height of 2 r w at each of them.
    for (Play& play : plays_) play.weight *= parameters["width_dph"] / sum;
  }

  double step(const GyroState& state) override {
    const double degc = state.thermal->coil_mean_degc();
    double bias_dph = 0;
    for (Play& play : plays_) {
      if (!started_) play.output_degc = degc;
      play.output_degc =
          std::clamp(play.output_degc, degc - play.threshold_k, degc + play.threshold_k);
      // Less the temperature itself: single-valued functions belong to the static bias.
      bias_dph += play.weight * (degc - play.output_degc);
    }
    started_ = true;
    return bias_dph;
  }

 private:
  struct Play {
    double threshold_k = 0;
    double weight = 0;  ///< deg/h per K
    double output_degc = 0;
  };

  std::vector<Play> plays_;
  bool started_ = false;
};

}  // namespace

EffectDescription thermal_hysteresis_effect() {
  return {"thermal_hysteresis",
          "the bias at a temperature depends on the turning points before it, not on the rate",
          {peak_parameter(),
           scale_parameter(),
           {"width_dph", "deg/h", 0.03, 0, 1e3, "of a full loop, warming less cooling branch"},
           {"threshold_k", "K", 6, 0.5, 60, "typical reversal that moves the bias"}},
          make_effect<ThermalHysteresis>};
}

}  // namespace fogcomp::simulation
