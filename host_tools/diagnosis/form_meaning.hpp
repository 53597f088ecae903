#pragma once

#include <array>
#include <cstddef>

namespace fogcomp::diagnosis {

/// Meaning of a form of the residual that the catalogue lacks: what may give it.
enum class FormMeaning {
  squared_rate,
  one_direction,
  bent_rate,
  late,
  twice_late,
  onset,
  first_heat,
  interference,
  late_interference,
  late_scale_factor,
  scale_factor,
  input,
  bent_input,
  product,
};

struct FormMeaningDescription {
  FormMeaning meaning;
  const char* forms;  ///< examples; x, y: any signals
  const char* mechanisms;
};

/// In the order of FormMeaning (host_tools/EFFECTS.md).
inline constexpr std::array<FormMeaningDescription, 14> kFormMeanings{{
    {FormMeaning::squared_rate, "dTdt^2, T*dTdt^2",
     "stress that a gradient makes whatever its direction: former or potting bends; heating that "
     "goes with the square of a current"},
    {FormMeaning::one_direction, "abs(dTdt), max(dTdt-c,0), dTdt*abs(dTdt)",
     "a contact or a clearance that opens in one direction, friction, a heater that works in one "
     "direction only"},
    {FormMeaning::bent_rate, "T^2*dTdt, (T-c)^2*dTdt, dTdt^3",
     "the thermo-optic coefficient or the stiffness of a coating changes with temperature more "
     "than in a straight line; convection"},
    {FormMeaning::late, "lag(x,tau), lag(x,tau)^2, lag(x^2,tau)",
     "what drives it has a heat capacity of its own: housing, electronics, source; squared after "
     "the lag, what comes late bends or heats"},
    {FormMeaning::twice_late, "lag(lag(x,tau),tau)^2",
     "what drives it sits behind two masses in a chain, as a coil in its housing: it begins more "
     "slowly than behind one"},
    {FormMeaning::onset, "max(x-c,0)",
     "something begins at a temperature or another value: a phase change of an adhesive, a "
     "thermostat, condensation"},
    {FormMeaning::first_heat, "highest(T), max(highest(T)-c,0)",
     "a coil's first heat, of which something remains: glue cures on, a joint or a winding "
     "settles; conditioning above the highest operating temperature before the calibration "
     "prevents it"},
    {FormMeaning::interference, "sin(x/p), sin(T/p+c)*dTdt",
     "interference or a 2 pi reset: a spurious path, also one that a gradient feeds; a reset error "
     "that goes with the rate"},
    {FormMeaning::late_interference, "sin(lag(T,tau)/p+c)",
     "interference in a path away from the sensor (coupler, modulator), warmed later than it"},
    {FormMeaning::late_scale_factor, "dTdt*W, W*exp(-t/tau)",
     "scale factor of a part (source, loop) that is warmed later or earlier than the "
     "sensor, or that warms itself after power-on"},
    {FormMeaning::scale_factor, "W^2, abs(W), W^3",
     "scale factor: offset of the detector (even), dead band, sine of an open loop (odd)"},
    {FormMeaning::input, "x",
     "sensitivity to x in a straight line, as of a supply that is not quite rejected"},
    {FormMeaning::bent_input, "x^2, x^3, abs(x)",
     "sensitivity to x that is no straight line: a power that goes with its square, something that "
     "saturates or does not tell its sign"},
    {FormMeaning::product, "x*y", "sensitivity to x that itself depends on y"},
}};

constexpr const char* mechanisms_of(FormMeaning meaning) {
  return kFormMeanings[static_cast<std::size_t>(meaning)].mechanisms;
}

}  // namespace fogcomp::diagnosis
