#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Median of at most 65537 spacings spread over the recording, s; 0 for one row.
double median_spacing_s(const std::vector<double>& time_s);

/// Sets period and stretch_starts from the times. Throws InputError for a period that is impossible
/// in seconds.
void find_stretches(Recording& recording);

}  // namespace fogcomp::recording
