#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::cli {

/// Writes all columns of a recording in the plain format, without names of segments.
void write_recording(const recording::Recording& recording, const std::string& path);

}  // namespace fogcomp::cli
