#pragma once

#include <cstdint>

#include "core/fixed_point/fixed.hpp"
#include "core/signal/quantities.hpp"

namespace fog {

/// R / R0: the resistance of a platinum thermometer over that at 0 degC.
using ResistanceRatio = Fixed<std::int32_t, 28>;

/// Temperature of a platinum thermometer of IEC 60751 (Callendar-Van Dusen: A = 3.9083e-3 /degC,
/// B = -5.775e-7 /degC^2, below 0 degC also C = -4.183e-12 /degC^4).
///
/// Newton's method on the standard's polynomial, so there is no table to verify. Within 2.63e-5
/// degC of it over -100...+200 degC, at every ratio (tests/bench/core_functions.cpp); ratios
/// outside that range are clipped. A larger ratio may give less by 1 LSB: rounding of the
/// polynomial, 59 times between 1.8 and 3.1 degC.
Temperature platinum_temperature(ResistanceRatio ratio);

/// Ratio of a thermometer in a divider: supply (the ADC's reference) - `reference` - node -
/// thermometer - ground. `code_sum`: sum of the node's ADC codes; `full_scale`: this sum at the
/// supply; code_sum < full_scale < 2^31. `reference`: upper resistor / R0. Saturates: an open
/// sensor reads as the highest ratio, a shorted one as 0.
ResistanceRatio divider_ratio(std::uint32_t code_sum, std::uint32_t full_scale,
                              ResistanceRatio reference);

}  // namespace fog
