#pragma once

#include <string>
#include <vector>

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Questions about a recording with values that no gyro, coil or chamber can have, which suggests
/// another unit: `FILE: what; what it may be`, one line each. `white_noise_dph_rthz`: of the rate,
/// deg/h in 1 s; 0 if unknown. Bounds: decision_rules.hpp.
std::vector<std::string> doubts(const Recording& recording, double white_noise_dph_rthz);

/// The first of them that a wrong unit of the time explains; "" for none.
std::string doubt_of_time(const Recording& recording);

}  // namespace fogcomp::recording
