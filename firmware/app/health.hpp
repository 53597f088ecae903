#pragma once

#include "core/frames/health_record.hpp"

namespace fog::app {

/// Counts a sample that was answered.
void count_health(const OutputSample& sample);

/// Answers requests received on the output port, between two frames: health records and, if the
/// header selects them, KVH commands.
void answer_requests();

/// Sends the results of the tests at the start as a KVH gyro does, if its commands are answered.
void report_start_tests();

/// Whether frames are sent: not in the configuration mode of the KVH commands.
bool sends_frames();

}  // namespace fog::app
