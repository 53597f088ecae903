#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// An open loop outputs the sine of the Sagnac phase; the effect is its deviation from a
// least-squares straight line. An offset of the bias point makes it asymmetric. For small phases a
// this is -a^2 / 15 of Legendre's third polynomial and a / 3 tan(offset) of the second.
class ScaleFactorNonlinearity : public Effect {
 public:
  ScaleFactorNonlinearity(const Parameters& parameters, const EffectContext&)
      : full_scale_dph_(parameters["full_scale_dps"] * kDphPerDegreePerSecond),
        sign_(std::copysign(1, parameters["ppm"])),
        phase_(std::sqrt(15e-6 * std::abs(parameters["ppm"]))),
        offset_(std::atan(3e-6 * sign_ * parameters["even_ppm"] / std::max(phase_, 1e-9))),
        slope_(phase_ > 1e-3
                   ? 3 * (std::sin(phase_) - phase_ * std::cos(phase_)) / std::pow(phase_, 3)
                   : 1) {}

  double step(const GyroState& state) override {
    if (phase_ == 0) return 0;
    const double u = state.input_rate_dph / full_scale_dph_;
    const double shown =
        (std::sin(phase_ * u + offset_) - std::sin(offset_)) / (phase_ * std::cos(offset_));
    return -sign_ * full_scale_dph_ * (shown - slope_ * u);
  }

 private:
  double full_scale_dph_;
  double sign_;
  double phase_;  // at full scale
  double offset_;
  double slope_;
};

}  // namespace

EffectDescription scale_factor_nonlinearity_effect() {
  return {"scale_factor_nonlinearity",
          "sine of an open loop behind its linearisation; needs an input rate",
          {peak_parameter(),
           scale_parameter(),
           {"ppm", "ppm", 300, -1e5, 1e5, "of full scale, odd"},
           {"even_ppm", "ppm", 0, -1e4, 1e4, "of full scale, even"},
           {"full_scale_dps", "deg/s", 100, 0.01, 1000, "rate of that phase"}},
          make_effect<ScaleFactorNonlinearity>};
}

}  // namespace fogcomp::simulation
