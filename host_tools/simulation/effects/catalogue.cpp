#include "simulation/effects/effect_list.hpp"

namespace fogcomp::simulation {

const std::vector<EffectDescription>& effect_catalogue() {
  static const std::vector<EffectDescription> catalogue{
      bias_effect(),
      bias_temperature_effect(),
      temperature_rate_effect(),
      shupe_effect(),
      thermal_lag_effect(),
      temperature_rate_product_effect(),
      axial_gradient_effect(),
      polarization_ripple_effect(),
      thermal_hysteresis_effect(),
      glass_transition_effect(),
      warm_up_effect(),
      aging_effect(),
      magnetic_effect(),
      vibration_effect(),
      light_power_effect(),
      bias_step_effect(),
      random_telegraph_effect(),
      fast_cycle_effect(),
      squared_lag_effect(),
      warmest_so_far_effect(),
      rate_nonlinearity_effect(),
      proper_frequency_effect(),
      moisture_exchange_effect(),
      pyroelectric_effect(),
      scale_factor_effect(),
      scale_factor_temperature_effect(),
      scale_factor_nonlinearity_effect(),
      scale_factor_asymmetry_effect(),
      late_reference_effect(),
      half_wave_voltage_effect(),
      dead_band_effect(),
  };
  return catalogue;
}

ParameterSpec peak_parameter() {
  return {"peak", "deg/h", 0, 0, 1e6, "largest magnitude over this programme; 0: natural size"};
}

ParameterSpec scale_parameter() {
  return {"scale", "", 1, -1e9, 1e9, "times the natural size, the same on every programme"};
}

}  // namespace fogcomp::simulation
