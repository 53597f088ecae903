#pragma once

#include <cstdint>

namespace fog {

// For c = 1 + i/16, i = 0..16: round(2^30 ln c) and round(2^30 / c). The test "LogarithmTable"
// recomputes every entry.
inline constexpr std::int32_t kLogarithmTable[17] = {
    0,         65095192,  126468572, 184522808, 239598564, 291986604,
    341937090, 389666807, 435364845, 479197128, 521310048, 561833416,
    600882877, 638561895, 674963409, 710171213, 744261118,
};
inline constexpr std::int32_t kReciprocalTable[17] = {
    1073741824, 1010580540, 954437177, 904203641, 858993459, 818089009,
    780903145,  746950834,  715827883, 687194767, 660764199, 636291451,
    613566757,  592409282,  572662306, 554189329, 536870912,
};

}  // namespace fog
