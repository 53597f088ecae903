#pragma once

#include "recording/recording.hpp"

namespace fogcomp::noise {

/// White noise density of the rate, deg/h in 1 s (angle random walk in deg/sqrt(h), times 60), from
/// the median absolute second difference of neighbouring samples, which neither drift nor outliers
/// affect. 0 for fewer than four rows.
double white_noise_dph_rthz(const recording::Recording& recording);

}  // namespace fogcomp::noise
