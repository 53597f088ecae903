#pragma once

#include "recording/recording.hpp"

namespace fogcomp::recording {

/// Seconds from one line of a table to the next: longer than anything that a model remembers.
constexpr double kDwellSpacingS = 36000;

/// Makes of rows, kDwellSpacingS apart, the means at steady temperatures that they are. Neither
/// their order nor the time since power-on means anything: each is a stretch by itself, and their
/// times lie before power-on.
void become_table(Recording& recording);

}  // namespace fogcomp::recording
