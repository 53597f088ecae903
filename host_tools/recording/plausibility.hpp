#pragma once

#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Questions that a recording raises whose figures no gyro, coil or chamber can have, as those of
/// another unit are: `FILE: what; what it may be`, a line each. `white_noise_dph_rthz`: of the
/// rate, deg/h in 1 s; 0 where it has none. Bounds: decision_rules.hpp.
std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz);

}  // namespace fogcomp::recording
