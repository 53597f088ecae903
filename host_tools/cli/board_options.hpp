#pragma once

#include <vector>

#include "board/board_table.hpp"
#include "cli/arguments.hpp"

namespace fogcomp::cli {

/// The options of the commands that make a board's table: --sample-rate, --output,
/// --extension.
std::vector<Option> board_options();

/// Takes a model whose integers are too far off all the same.
inline constexpr const char* kAllowError = "allow-error";

/// Their values.
BoardSettings board_settings(const Arguments& arguments);

}  // namespace fogcomp::cli
