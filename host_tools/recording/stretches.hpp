#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Sets period and stretch_starts from the times. Throws InputError for a period that is impossible
/// in seconds.
void find_stretches(Recording& recording);

}  // namespace fogcomp::recording
