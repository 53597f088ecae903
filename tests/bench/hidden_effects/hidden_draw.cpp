#include "hidden_draw.hpp"

#include <algorithm>

#include "support/input_error.hpp"
#include "support/text.hpp"

namespace fogcomp::bench {
namespace {

// The order above the one declared.
HiddenEffect next_order(const DrawnGyro& gyro) {
  const bool declared_line = std::find(gyro.declared.begin(), gyro.declared.end(),
                                       "bias_temperature:order=1") != gyro.declared.end();
  return {"bias_temperature", "", "", declared_line ? "curvature" : "cubic",
          declared_line ? 1e-5 : 1e-7};
}

std::string catalogued_parameters(Draws& draws, const std::string& what) {
  if (what == "temperature_rate") return "coefficient=0.1";
  if (what == "shupe") return format("asymmetry_m=%.3f", draws.ratio(0.1, 2));
  if (what == "thermal_lag") return format("tau_s=%.0f", draws.ratio(120, 3000));
  if (what == "temperature_rate_product") return "coefficient=1e-3";
  if (what == "axial_gradient") {  // mostly stress: rows of 10 s are too long for the transients
    return format("asymmetry_m=%.3f,stress=%.4f", draws.ratio(0.01, 0.15),
                  draws.sign() * draws.ratio(0.02, 0.08));
  }
  if (what == "polarization_ripple") {
    return format("period_k=%.2f,phase_deg=%.0f,second=%.2f", draws.ratio(4, 40),
                  draws.uniform(-180, 180), draws.uniform(0, 0.3));
  }
  if (what == "thermal_hysteresis") return format("threshold_k=%.2f", draws.ratio(2, 15));
  if (what == "glass_transition") {
    return format("tg_degc=%.1f,width_k=%.1f,step_dph=%.4f,rate_term=%.4f", draws.uniform(-30, 45),
                  draws.ratio(1.5, 7), draws.ratio(0.01, 0.1),
                  draws.sign() * draws.ratio(0.01, 0.2));
  }
  if (what == "scale_factor_temperature") {
    return format("wavelength_ppm=%.1f,coil_ppm=%.1f", draws.ratio(2, 300), draws.ratio(2, 10));
  }
  if (what == "warm_up") return format("tau_s=%.0f", draws.ratio(300, 7200));
  if (what == "aging") {
    return format("creep_dph=%.4f,moisture_dph=%.4f,onset_s=%.0f,activation_ev=%.2f",
                  draws.ratio(0.003, 0.03), draws.ratio(0.001, 0.01), draws.ratio(1200, 36000),
                  draws.uniform(0.05, 0.3));
  }
  if (what == "magnetic") {
    return format("temperature_slope=%.1e", draws.sign() * draws.ratio(5e-4, 5e-3));
  }
  if (what ==
      "bias_step") {  // one jump that stays, anywhere in the middle of the shortest programme
    return format("per_hour=0,first_s=%.0f", draws.uniform(5000, 32000));
  }
  if (what == "vibration" || what == "light_power") return "";
  throw InputError("effect '" + what + "'", "is not one that the benchmark hides");
}

std::string foreign_parameters(Draws& draws, const std::string& name) {
  if (name == "random_telegraph") return format("dwell_s=%.0f", draws.ratio(900, 7200));
  if (name == "fast_cycle") {
    return format("period_s=%.1f,phase_deg=%.0f,second=%.2f", draws.ratio(90, 1200),
                  draws.uniform(-180, 180), draws.uniform(0, 0.4));
  }
  if (name == "squared_lag") return format("tau_s=%.0f", draws.ratio(300, 3600));
  return "";
}

}  // namespace

std::string HiddenEffect::option(double value) const {
  std::string text = name + ":";
  if (!form.empty()) text += "form=" + form + ",";
  if (!parameters.empty()) text += parameters + ",";
  return text + sized + format("=%.6g", value);
}

const std::vector<std::string>& catalogued_effects() {
  static const std::vector<std::string> names{
      "bias_temperature",
      "temperature_rate",
      "shupe",
      "thermal_lag",
      "temperature_rate_product",
      "axial_gradient",
      "polarization_ripple",
      "thermal_hysteresis",
      "glass_transition",
      "scale_factor_temperature",
      "warm_up",
      "aging",
      "magnetic",
      "vibration",
      "light_power",
      "bias_step",
  };
  return names;
}

const std::vector<std::string>& foreign_disturbances() {
  static const std::vector<std::string> names{
      "random_telegraph",
      "fast_cycle",
      "squared_lag",
      "warmest_so_far",
      "rate_nonlinearity/magnitude",
      "rate_nonlinearity/square",
      "rate_nonlinearity/temperature_squared",
  };
  return names;
}

HiddenEffect draw_hidden(Draws& draws, const std::string& what, const DrawnGyro& gyro) {
  if (what == "bias_temperature") return next_order(gyro);
  const std::vector<std::string> words = split(what, '/');
  const auto& foreign = foreign_disturbances();
  if (std::find(foreign.begin(), foreign.end(), what) != foreign.end()) {
    return {words[0], words.size() > 1 ? words[1] : "", foreign_parameters(draws, words[0]),
            "scale"};
  }
  return {what, "", catalogued_parameters(draws, what), "scale"};
}

std::vector<std::string> programmes_that_show(const std::string& what) {
  if (what == "axial_gradient") return {"heater_pulses"};
  if (what == "scale_factor_temperature") return {"axis_flips", "rate_table"};
  if (what == "magnetic" || what == "vibration") return {"field_and_vibration"};
  return {};
}

std::string columns_that_show(const std::string& what) {
  if (what == "axial_gradient") return "temperature2";
  if (what == "magnetic") return "magnetic";
  if (what == "vibration") return "vibration";
  if (what == "light_power") return "light_power";
  return "";
}

}  // namespace fogcomp::bench
