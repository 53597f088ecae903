#pragma once

#include "simulation/effects/effect.hpp"

namespace fogcomp::simulation {

// Defined beside their classes: of rotation, temperature_course, memory, power_on, surroundings.
EffectDescription aging_effect();
EffectDescription axial_gradient_effect();
EffectDescription bias_effect();
EffectDescription bias_step_effect();
EffectDescription bias_temperature_effect();
EffectDescription dead_band_effect();
EffectDescription fast_cycle_effect();
EffectDescription glass_transition_effect();
EffectDescription half_wave_voltage_effect();
EffectDescription late_reference_effect();
EffectDescription light_power_effect();
EffectDescription magnetic_effect();
EffectDescription polarization_ripple_effect();
EffectDescription proper_frequency_effect();
EffectDescription moisture_exchange_effect();
EffectDescription pyroelectric_effect();
EffectDescription random_telegraph_effect();
EffectDescription rate_nonlinearity_effect();
EffectDescription scale_factor_asymmetry_effect();
EffectDescription scale_factor_effect();
EffectDescription scale_factor_nonlinearity_effect();
EffectDescription scale_factor_temperature_effect();
EffectDescription shupe_effect();
EffectDescription squared_lag_effect();
EffectDescription temperature_rate_effect();
EffectDescription temperature_rate_product_effect();
EffectDescription thermal_hysteresis_effect();
EffectDescription thermal_lag_effect();
EffectDescription vibration_effect();
EffectDescription warm_up_effect();
EffectDescription warmest_so_far_effect();

}  // namespace fogcomp::simulation
