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
  if (what == "scale_factor_nonlinearity") {
    return format("%s,full_scale_dps=%.0f",
                  draws.chance(0.5) ? "ppm=300,even_ppm=0" : "ppm=0,even_ppm=300",
                  draws.ratio(60, 300));
  }
  if (what == "scale_factor_asymmetry") {
    return format("rounded_dps=%.4f", draws.ratio(0.005, 0.1));
  }
  if (what == "late_reference") return format("delay_ms=%.1f", draws.ratio(5, 100));
  if (what == "vibration" || what == "light_power" || what == "scale_factor") return "";
  throw InputError("effect '" + what + "'", "is not one that the benchmark hides");
}

std::string foreign_parameters(Draws& draws, const std::string& name) {
  if (name == "random_telegraph") return format("dwell_s=%.0f", draws.ratio(900, 7200));
  if (name == "fast_cycle") {
    return format("period_s=%.1f,phase_deg=%.0f,second=%.2f", draws.ratio(90, 1200),
                  draws.uniform(-180, 180), draws.uniform(0, 0.4));
  }
  if (name == "pyroelectric") {
    return format("threshold_k=%.1f,leak_s=%.0f", draws.ratio(2, 8), draws.ratio(100, 1000));
  }
  if (name == "moisture_exchange") {
    return format("tau_s=%.0f,activation_ev=%.2f", draws.ratio(1800, 36000),
                  draws.uniform(0.3, 0.6));
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

const std::vector<std::string>& scale_factor_effects() {
  static const std::vector<std::string> names{"scale_factor", "scale_factor_temperature",
                                              "scale_factor_nonlinearity",
                                              "scale_factor_asymmetry"};
  return names;
}

const std::vector<std::string>& rate_faults() {
  static const std::vector<std::string> names{"late_reference", "fast_cycle"};
  return names;
}

bool is_catalogued(const std::string& what) {
  const auto among = [&](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), what) != names.end();
  };
  return among(catalogued_effects()) || among(scale_factor_effects()) || what == "late_reference";
}

const std::vector<std::string>& hidden_formulas() {
  static const std::vector<std::string> names{
      "rate_nonlinearity/magnitude", "rate_nonlinearity/square",
      "rate_nonlinearity/temperature_squared", "squared_lag", "warmest_so_far"};
  return names;
}

const std::vector<std::string>& other_disturbances() {
  static const std::vector<std::string> names{"random_telegraph", "fast_cycle", "moisture_exchange",
                                              "pyroelectric"};
  return names;
}

HiddenEffect draw_hidden(Draws& draws, const std::string& what, const DrawnGyro& gyro) {
  if (what == "bias_temperature") return next_order(gyro);
  if (is_catalogued(what)) return {what, "", catalogued_parameters(draws, what), "scale"};
  const std::vector<std::string> words = split(what, '/');
  return {words[0], words.size() > 1 ? words[1] : "", foreign_parameters(draws, words[0]), "scale"};
}

std::vector<std::string> programmes_that_show(const std::string& what) {
  if (what == "axial_gradient") return {"heater_pulses"};
  if (what == "scale_factor_temperature") return {"axis_flips", "rate_table"};
  if (what == "magnetic" || what == "vibration") return {"field_and_vibration"};
  return {};
}

std::vector<std::string> turning_programmes_that_show(const std::vector<std::string>& hidden) {
  if (hidden.empty() || hidden[0] == "fast_cycle") {
    return {"rate_table", "rate_steps", "rate_sweeps"};
  }
  if (hidden[0] == "late_reference") return {"rate_sweeps"};
  // A single magnitude of the rate does not separate a nonlinearity from the scale factor, a single
  // temperature shows no slope.
  if (hidden[0] == "scale_factor_temperature") return {"rate_table", "rate_steps"};
  return {"rate_steps", "rate_sweeps"};
}

std::string columns_that_show(const std::string& what) {
  if (what == "axial_gradient") return "temperature2";
  if (what == "magnetic") return "magnetic";
  if (what == "vibration") return "vibration";
  if (what == "light_power") return "light_power";
  return "";
}

}  // namespace fogcomp::bench
