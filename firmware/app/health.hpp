#pragma once

#include "core/frames/health_record.hpp"

namespace fog::app {

/// Counts a sample that was answered.
void count_health(const OutputSample& sample);

/// Answers what the user has asked for on the output port, between two frames: health records, and
/// where the header has chosen so, KVH's commands.
void answer_requests();

/// Whether frames are to be sent: not in the configuration mode of KVH's commands.
bool sends_frames();

}  // namespace fog::app
