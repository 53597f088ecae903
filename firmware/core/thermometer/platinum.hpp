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
/// Newton's method on the standard's own polynomial, so there is no table to trust. Within
/// 0.0001 degC of it over -100...+200 degC (tests/unit/thermometer/platinum_test.cpp); ratios
/// beyond those of that range are clipped to its ends.
Temperature platinum_temperature(ResistanceRatio ratio);

/// Ratio of a thermometer in a divider: supply (the ADC's reference) - `reference` - node -
/// thermometer - ground. `code_sum` is the sum of the node's ADC codes, `full_scale` what that sum
/// would be at the supply; code_sum < full_scale < 2^31. `reference` is the upper resistor over R0.
/// Saturates: a broken sensor reads as the highest ratio, a short as 0.
ResistanceRatio divider_ratio(std::uint32_t code_sum, std::uint32_t full_scale,
                              ResistanceRatio reference);

}  // namespace fog
