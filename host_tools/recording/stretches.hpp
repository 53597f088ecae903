#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Fills in period and stretch_starts from the times. Throws InputError for a period that no
/// recording in seconds has.
void find_stretches(Recording& recording);

}  // namespace fogcomp::recording
