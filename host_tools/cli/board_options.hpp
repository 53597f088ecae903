#pragma once

#include "cli/arguments.hpp"
#include "quantization/board_table.hpp"

namespace fogcomp::cli {

/// --sample-rate and --output: what the board is to do, for export and replay.
void add_board_options(Command& command, const char* default_sample_rate);

/// The settings given. The sample rate must be there.
BoardSettings board_options(const Arguments& arguments);

}  // namespace fogcomp::cli
