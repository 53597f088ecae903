#pragma once

#include <string>

#include "recording/recording.hpp"

namespace fogcomp::cli {

/// Writes all columns that a recording has, in the plain format. Names of segments are not kept.
void write_recording(const recording::Recording& recording, const std::string& path);

}  // namespace fogcomp::cli
