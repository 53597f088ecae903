#include <cmath>

#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

constexpr double kSpan_k = 40;  ///< above and below the reference, where T^2 counts as 1

enum class Form { magnitude, square, temperature_squared };

// Terms of an expansion in T and dT/dt without a physical effect of the catalogue.
class RateNonlinearity : public Effect {
 public:
  RateNonlinearity(const Parameters& parameters, const EffectContext&)
      : coefficient_(parameters["coefficient"]), form_(static_cast<Form>(parameters["form"])) {}

  double step(const GyroState& state) override {
    const double kpmin = state.thermal->coil_mean_rate_kps() * kSecondsPerMinute;
    const double place = (state.thermal->coil_mean_degc() - kReference_degc) / kSpan_k;
    switch (form_) {
      case Form::magnitude:
        return coefficient_ * std::abs(kpmin);
      case Form::square:
        return coefficient_ * kpmin * kpmin;
      case Form::temperature_squared:
        break;
    }
    return coefficient_ * place * place * kpmin;
  }

 private:
  double coefficient_;
  Form form_;
};

}  // namespace

EffectDescription rate_nonlinearity_effect() {
  return {"rate_nonlinearity",
          "|dT/dt|, (dT/dt)^2 or (T - 20)^2 dT/dt (simulator only)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h", 0.05, -1e4, 1e4, "at 1 K/min, for the last also 60 degC"},
           {"form", "", 0, 0, 0, "which", {"magnitude", "square", "temperature_squared"}}},
          make_effect<RateNonlinearity>};
}

}  // namespace fogcomp::simulation
