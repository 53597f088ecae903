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
      proper_frequency_effect(),
      pyroelectric_effect(),
      scale_factor_temperature_effect(),
      half_wave_voltage_effect(),
      dead_band_effect(),
  };
  return catalogue;
}

ParameterSpec peak_parameter() {
  return {"peak", "deg/h", 0, 0, 1e6, "largest magnitude over this programme; 0: natural size"};
}

}  // namespace fogcomp::simulation
