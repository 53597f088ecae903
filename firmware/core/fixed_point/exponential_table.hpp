#pragma once

#include <cstdint>

namespace fog {

// round(2^30 2^(-i/16)), i = 0..15. The test "ExponentialTable" recomputes every entry.
inline constexpr std::int32_t kExponentialTable[16] = {
    1073741824, 1028218693, 984625594, 942880699, 902905651, 864625413, 827968132, 792865000,
    759250125,  727060411,  696235434, 666717336, 638450708, 611382493, 585461881, 560640218,
};

}  // namespace fog
