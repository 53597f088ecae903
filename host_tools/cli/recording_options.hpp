#pragma once

#include "cli/arguments.hpp"
#include "dataset/recording.hpp"

namespace fogcomp::cli {

void add_recording_options(Command& command);
ReadOptions recording_options(const Arguments& arguments);

}  // namespace fogcomp::cli
