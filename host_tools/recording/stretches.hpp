#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Period of which spacings are whole multiples, from their median on, s; of at most 65537 spread
/// over the recording. 0 for one row, and if most rows have the time of the one before.
double median_spacing_s(const std::vector<double>& time_s);

/// Sets period and stretch_starts from the times. Throws InputError for a period that is impossible
/// in seconds.
void find_stretches(Recording& recording);

/// Seconds from one line of a table to the next: longer than anything that a model remembers.
constexpr double kDwellSpacingS = 36000;

/// Makes of rows, kDwellSpacingS apart, the means at steady temperatures that they are. Neither
/// their order nor the time since power-on means anything: each is a stretch by itself, and their
/// times lie before power-on.
void become_table(Recording& recording);

}  // namespace fogcomp::recording
