#pragma once

#include "core/frames/health_record.hpp"

namespace fog::app {

/// Counts a sample that was answered.
void count_health(const OutputSample& sample);

/// Answers what the user has asked for on the output port, between two frames.
void answer_requests();

}  // namespace fog::app
