#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Period of which spacings are whole multiples, from their median on, s; of at most 65537 spread
/// over the recording. 0 for one row, and if most rows have the time of the one before.
double median_spacing_s(const std::vector<double>& time_s);

/// Sets period and stretch_starts from the times. Throws InputError for a period that is impossible
/// in seconds.
void find_stretches(Recording& recording);

}  // namespace fogcomp::recording
