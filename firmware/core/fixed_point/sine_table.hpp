#pragma once

#include <cstdint>

namespace fog {

// round(2^30 sin(2 pi i / 64)), i = 0..16: a quarter turn. The test "SineTable" recomputes every
// entry.
inline constexpr std::int32_t kSineTable[17] = {
    0,         105245103,  209476638,  311690799,  410903207,  506158392,
    596538995, 681174602,  759250125,  830013654,  892783698,  946955747,
    992008094, 1027506862, 1053110176, 1068571464, 1073741824,
};

}  // namespace fog
