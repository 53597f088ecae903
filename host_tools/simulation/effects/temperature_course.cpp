// Effects of the coil's temperatures and of how fast they change.

#include <cmath>

#include "simulation/coil.hpp"
#include "simulation/effects/effect_list.hpp"
#include "support/units.hpp"

namespace fogcomp::simulation {
namespace {

// Slow residual errors of polarisation, electronics and pick-up: a smooth function of the
// temperature of their part.
class BiasTemperature : public Effect {
 public:
  BiasTemperature(const Parameters& parameters, const EffectContext&)
      : slope_(parameters["slope"]),
        curvature_(parameters["curvature"]),
        cubic_(parameters["cubic"]),
        at_optics_(parameters["at"] == 1) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    const double x =
        (at_optics_ ? thermal.optics_degc() : thermal.coil_mean_degc()) - kReference_degc;
    return x * (slope_ + x * (curvature_ + x * cubic_));
  }

 private:
  double slope_;
  double curvature_;
  double cubic_;
  bool at_optics_;
};

}  // namespace

EffectDescription bias_temperature_effect() {
  return {"bias_temperature",
          "static temperature sensitivity of the bias, zero at 20 degC (IEEE 952: D_T)",
          {peak_parameter(),
           scale_parameter(),
           {"slope", "deg/h/K", 3e-4, -1, 1, "of the temperature above 20 degC"},
           {"curvature", "deg/h/K^2", 3e-6, -1, 1, "of its square"},
           {"cubic", "deg/h/K^3", 0, -1, 1, "of its cube"},
           {"at", "", 0, 0, 0, "whose temperature counts", {"coil", "optics"}}},
          make_effect<BiasTemperature>};
}

namespace {

// Mohr effect: the same temperature change strains the layers differently, so that the two halves
// of the fibre, which are in different layers, do not cancel.
class TemperatureRate : public Effect {
 public:
  TemperatureRate(const Parameters& parameters, const EffectContext& context)
      : kernel_(parameters["coefficient"] != 0
                    ? parameters["coefficient"] * unit_stress_kernel(context.coil_error)
                    : stress_kernel(context.coil_error, 1e-6 * parameters["inside_ppm"],
                                    1e-6 * parameters["outside_ppm"])) {}

  double step(const GyroState& state) override {
    return (kernel_ * state.thermal->coil_rate_kps()).sum();
  }

 private:
  CellArray kernel_;
};

}  // namespace

EffectDescription temperature_rate_effect() {
  return {
      "temperature_rate",
      "elasto-optic stress differs from layer to layer: K dT/dt (Mohr; IEEE 952: D_Tdot)",
      {peak_parameter(),
       scale_parameter(),
       {"coefficient", "deg/h/(K/min)", 0, -1e3, 1e3, "in a long ramp; 0: what the strains give"},
       {"inside_ppm", "ppm/K", 1e6 * kStrainInside, -100, 100, "strain of the innermost layer"},
       {"outside_ppm", "ppm/K", 1e6 * kStrainOutside, -100, 100, "of the outermost"}},
      make_effect<TemperatureRate>};
}

namespace {

// Coating and potting stiffen roughly exponentially towards low temperatures.
constexpr double kStiffening_per_k = 0.004;

// kappa depends on temperature: mainly through the modulus of coating and potting, a little through
// dn/dT of the glass.
class TemperatureRateProduct : public Effect {
 public:
  TemperatureRateProduct(const Parameters& parameters, const EffectContext& context)
      : stress_kernel_(parameters["coefficient"] * unit_stress_kernel(context.coil_error)),
        glass_kernel_(context.coil_error.kernel_dph_s() *
                      context.coil_error.material().thermo_optic_per_k *
                      context.coil_error.material().thermo_optic_slope_per_k) {}

  double step(const GyroState& state) override {
    const CellArray above_k = state.thermal->coil_degc() - kReference_degc;
    const CellArray softening = (1 - (-kStiffening_per_k * above_k).exp()) / kStiffening_per_k;
    return ((stress_kernel_ * softening + glass_kernel_ * above_k) * state.thermal->coil_rate_kps())
        .sum();
  }

 private:
  CellArray stress_kernel_;
  CellArray glass_kernel_;
};

}  // namespace

EffectDescription temperature_rate_product_effect() {
  return {"temperature_rate_product",
          "the rate term's size depends on temperature: modulus of the potting, dn/dT(T)",
          {peak_parameter(),
           scale_parameter(),
           {"coefficient", "deg/h/(K/min)/K", 5e-4, -10, 10,
            "change of the rate term per K, at 20 degC"}},
          make_effect<TemperatureRateProduct>};
}

namespace {

// Thermo-optic part of the coil integral: zero if the whole coil warms uniformly.
class Shupe : public Effect {
 public:
  Shupe(const Parameters& parameters, const EffectContext& context)
      : coil_error_(context.coil_error),
        kappa_per_k_(context.coil_error.material().thermal_phase_per_k()),
        lead_(context.coil_error.lead_dph_s_per_k(parameters["asymmetry_m"])) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    return coil_error_.rate_dph(kappa_per_k_ * thermal.coil_rate_kps()) +
           lead_ * (thermal.coil_outside_rate_kps() - thermal.coil_mean_rate_kps());
  }

 private:
  CoilError coil_error_;
  double kappa_per_k_;
  double lead_;
};

}  // namespace

EffectDescription shupe_effect() {
  return {"shupe",
          "transient gradient through the winding (Shupe 1980; IEEE 952: D_gradTdot)",
          {peak_parameter(),
           scale_parameter(),
           {"asymmetry_m", "m", 0.2, -100, 100, "offset of the fibre's midpoint"}},
          make_effect<Shupe>};
}

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

namespace {

// The fibre's two ends leave the coil over different faces, so that one has the temperature of the
// lower face, the other that of the upper: n kappa d / D * d/dt(T_lower - T_upper). The difference
// itself also strains the clamped ends.
class AxialGradient : public Effect {
 public:
  AxialGradient(const Parameters& parameters, const EffectContext& context)
      : lead_(context.coil_error.lead_dph_s_per_k(parameters["asymmetry_m"]) / 2),
        stress_(parameters["stress"]) {}

  double step(const GyroState& state) override {
    const GyroThermalModel& thermal = *state.thermal;
    return lead_ * thermal.axial_difference_rate_kps() + stress_ * thermal.axial_difference_k();
  }

 private:
  double lead_;
  double stress_;
};

}  // namespace

EffectDescription axial_gradient_effect() {
  return {"axial_gradient",
          "gradient along the coil's axis; seen with --columns temperature2 and a heater profile",
          {peak_parameter(),
           scale_parameter(),
           {"asymmetry_m", "m", 1, -100, 100, "fibre on each face"},
           {"stress", "deg/h/K", 0.02, -100, 100, "of the lower face's excess over the upper's"}},
          make_effect<AxialGradient>};
}

}  // namespace fogcomp::simulation
